#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

/// Tests long work on the map, done piece by piece between messages.
namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::HasSubstr;
using testing::SizeIs;

/// Arranges a run, and a second one over the same floor.
struct MapWork : testing::Test {
  MapWork() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(40));
    Handed second = again.next(40);
    for (std::uint32_t index = 0; index < 40; index += 3) {
      second.batch.edges.push_back(stitch(run.place(index), again.place(index), 0.0, 0.1));
    }
    site.hand_in(r1, second);
    site.label("dock", run.place(39));
    site.hush();
  }
  msg::OperatorReply work(const msg::OperatorRequest& request) {
    site.say(request);
    site.pass(60s);
    return site.last<msg::OperatorReply>().value();
  }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
  TaughtRun again{r1, 11};
};

TEST_F(MapWork, ReplaceTakesOutWhatTheNewRunCovers) {
  msg::OperatorRequest request = site.request(Kind::replace);
  request.label = to_string(again.id());
  request.work.only_say = true;
  const msg::OperatorReply said = work(request);
  EXPECT_THAT(said.message, HasSubstr("places out of the map"));
  EXPECT_EQ(site.service().snapshot().place_count(), 80U) << "said, not done";
  request.request = site.request(Kind::replace).request;
  request.work.only_say = false;
  const msg::OperatorReply done = work(request);
  EXPECT_EQ(done.outcome, msg::Outcome::done) << done.message;
  EXPECT_EQ(done.revision, site.service().snapshot().revision());
  EXPECT_LT(site.service().snapshot().place_count(), 50U);
  EXPECT_NE(site.service().snapshot().place(run.place(39)), nullptr) << "a labelled place stays";
  msg::OperatorRequest undo = site.request(Kind::undo);
  undo.work.revision = done.revision;
  EXPECT_EQ(site.ask(undo).outcome, msg::Outcome::done);
  EXPECT_EQ(site.service().snapshot().place_count(), 80U);
}

TEST_F(MapWork, PlacesInUseAreNotPruned) {
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "dock", "r1");
  site.pass(1s);
  const Route route = site.last<msg::RouteOrder>().value().route;
  msg::OperatorRequest request = site.request(Kind::prune);
  work(request);
  for (const PlaceId& place : route.places) EXPECT_NE(site.service().snapshot().place(place), nullptr);
}

TEST_F(MapWork, CheckNamesWhatIsDamagedAndTheRestIsServed) {
  const msg::OperatorReply sound = work(site.request(Kind::check));
  EXPECT_EQ(sound.outcome, msg::Outcome::done) << sound.message;
  EXPECT_THAT(site.events_of("map.check_ended"), SizeIs(1));
}

TEST_F(MapWork, OneAtATimeAndRepeatsAreTheSame) {
  const msg::OperatorRequest first = site.request(Kind::prune);
  site.say(first);
  const msg::OperatorReply second = site.ask(site.request(Kind::check));
  EXPECT_EQ(second.outcome, msg::Outcome::refused);
  EXPECT_THAT(second.message, HasSubstr("is under way"));
  site.pass(60s);
  const msg::OperatorReply end = site.last<msg::OperatorReply>().value();
  EXPECT_EQ(end.request, first.request);
  EXPECT_EQ(site.ask(first).message, end.message);
}

TEST_F(MapWork, ASnapshotNeedsAPathOnTheServersMachine) {
  msg::OperatorRequest request = site.request(Kind::snapshot);
  request.work.file = "backup.sqlite";
  EXPECT_THAT(site.ask(request).message, HasSubstr("absolute path"));
}

TEST_F(MapWork, ASnapshotThatIsVerifiedNeedsOneTooAndAnEngineWithFiles) {
  msg::OperatorRequest request = site.request(Kind::snapshot_verified);
  request.work.file = "backup.sqlite";
  EXPECT_THAT(site.ask(request).message, HasSubstr("absolute path"));
  request = site.request(Kind::snapshot_verified);
  request.work.file = "/var/backups/site.sqlite";
  EXPECT_THAT(site.ask(request).message, HasSubstr("no file to copy"));
}

TEST_F(MapWork, MessagesAreAnsweredBetweenThePieces) {
  site.say(site.request(Kind::prune));
  const std::optional<SteadyTime> next = site.service().next_tick();
  ASSERT_TRUE(next);
  EXPECT_LE(*next, site.now.steady) << "work is done at once, but never keeps a message waiting for its end";
  site.label("gate", run.place(1));
  EXPECT_EQ(site.service().snapshot().labels().count("gate"), 1U);
}

}  // namespace
}  // namespace weft::server::test
