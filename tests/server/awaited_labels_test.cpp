#include "server/requests/awaited_labels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

/// Tests labels that wait for a run which its robot has not handed in: across restarts, and when it never comes.
namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct WaitingLabels : testing::Test {
  WaitingLabels() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(4));
    site.hush();
  }
  /// Asks for a label of a place that the robot keeps, and returns the request.
  msg::OperatorRequest give(const std::string& label, const PlaceId& place) {
    msg::OperatorRequest here = site.request(Kind::label_here);
    here.robot = "r1";
    here.label = label;
    site.say(here);
    const msg::AgentCommand keep = site.last<msg::AgentCommand>().value();
    site.say(msg::AgentReply{.header = r1.header(),
                             .command = keep.command,
                             .done = true,
                             .reason = "",
                             .place = place,
                             .experience = {},
                             .report = {},
                             .counts = {}});
    return here;
  }
  void restart() {
    site.restart();
    ++r1.incarnation;
    site.arrive(r1, std::nullopt);
  }
  Snapshot::Labels labels() { return site.service().snapshot().labels(); }
  /// Returns the latest reply to a request.
  std::optional<msg::OperatorReply> reply_to(const msg::OperatorRequest& request) {
    std::optional<msg::OperatorReply> latest;
    for (const msg::OperatorReply& reply : site.heard<msg::OperatorReply>()) {
      if (reply.to == site.client.id && reply.request == request.request) latest = reply;
    }
    return latest;
  }
  void expect_dropped(const msg::OperatorRequest& request, const std::string& why) {
    ASSERT_TRUE(reply_to(request));
    EXPECT_EQ(reply_to(request)->outcome, msg::Outcome::failed);
    EXPECT_THAT(reply_to(request)->message, HasSubstr(why));
    EXPECT_THAT(site.disk->awaited_labels, IsEmpty());
  }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
  TaughtRun held{r1, 20};
};

TEST_F(WaitingLabels, AreSetWhenTheRunComesAfterARestart) {
  const msg::OperatorRequest dock = give("dock", held.place(2));
  EXPECT_THAT(site.disk->awaited_labels, SizeIs(1));
  restart();
  EXPECT_EQ(reply_to(dock)->outcome, msg::Outcome::under_way) << "who waits is told at once";
  const std::uint64_t commits = site.disk->commits;
  site.hand_in(r1, held.next(4));
  EXPECT_EQ(labels().at("dock"), held.place(2));
  EXPECT_EQ(reply_to(dock)->outcome, msg::Outcome::done);
  EXPECT_THAT(site.disk->awaited_labels, IsEmpty());
  EXPECT_EQ(site.disk->commits, commits + 3) << "the batch; the end of the run before; the label, set and taken out";
  restart();
  EXPECT_EQ(labels().at("dock"), held.place(2));
  EXPECT_FALSE(reply_to(dock));
}

TEST_F(WaitingLabels, AreListedBesideTheRunsUntilTheyAreSet) {
  give("dock", held.place(2));
  const auto listed = [&] {
    return site.read(msg::Query::Kind::experiences).awaited_labels;
  };  // the last part has them
  const std::vector<msg::AwaitedLabelRow> rows = listed();
  ASSERT_THAT(rows, SizeIs(1));
  EXPECT_EQ(rows.front().label, "dock");
  EXPECT_EQ(rows.front().place, held.place(2));
  EXPECT_EQ(rows.front().robot, r1.id);
  site.hand_in(r1, held.next(4));
  EXPECT_THAT(listed(), IsEmpty());
}

TEST_F(WaitingLabels, OfOnePlaceAreBothKept) {
  give("dock", held.place(2));
  give("charger", held.place(2));
  restart();
  site.hand_in(r1, held.next(4));
  EXPECT_EQ(labels().at("dock"), held.place(2));
  EXPECT_EQ(labels().at("charger"), held.place(2));
}

TEST_F(WaitingLabels, AreNotDoubledByARequestThatIsRepeated) {
  const msg::OperatorRequest dock = give("dock", held.place(2));
  restart();
  site.hush();
  site.say(dock);
  EXPECT_THAT(site.heard<msg::AgentCommand>(), IsEmpty()) << "the robot has kept its place already";
  EXPECT_THAT(site.disk->awaited_labels, SizeIs(1));
  site.hand_in(r1, held.next(4));
  EXPECT_EQ(reply_to(dock)->outcome, msg::Outcome::done);
}

TEST_F(WaitingLabels, AreSetAtTheStartWhenTheirPlaceIsThere) {
  site.disk->awaited_labels["dock"] = {"dock", run.place(1), r1.id, site.client.id, 77, "anna"};
  restart();
  EXPECT_EQ(labels().at("dock"), run.place(1));
  EXPECT_THAT(site.disk->awaited_labels, IsEmpty());
}

TEST_F(WaitingLabels, AreWithdrawnByRemovingThem) {
  for (const bool restarts : {false, true}) {
    const msg::OperatorRequest dock = give("dock", held.place(2));
    if (restarts) restart();
    msg::OperatorRequest unlabel = site.request(Kind::label_remove);
    unlabel.label = "dock";
    EXPECT_EQ(site.ask(unlabel).outcome, msg::Outcome::done);
    expect_dropped(dock, "waits no longer");
  }
  restart();
  site.hand_in(r1, held.next(4));
  EXPECT_THAT(labels(), IsEmpty());
}

TEST_F(WaitingLabels, RemovedWithTheOneThatIsSet) {
  site.label("dock", run.place(1));
  const msg::OperatorRequest dock = give("dock", held.place(2));
  msg::OperatorRequest unlabel = site.request(Kind::label_remove);
  unlabel.label = "dock";
  const msg::OperatorReply removed = site.ask(unlabel);
  EXPECT_EQ(removed.outcome, msg::Outcome::done);
  EXPECT_THAT(removed.message, HasSubstr("waits no longer"));
  EXPECT_THAT(labels(), IsEmpty());
  expect_dropped(dock, "removed the label");
}

TEST_F(WaitingLabels, WaitNoLongerWhenTheirNameIsGivenAnew) {
  const msg::OperatorRequest first = give("dock", held.place(2));
  const msg::OperatorRequest second = give("dock", held.place(3));
  EXPECT_EQ(reply_to(first)->outcome, msg::Outcome::failed);
  EXPECT_EQ(site.disk->awaited_labels.at("dock").place, held.place(3));
  site.label("dock", run.place(1));
  expect_dropped(second, "gave the label to " + to_string(run.place(1)));
  site.hand_in(r1, held.next(4));
  EXPECT_EQ(labels().at("dock"), run.place(1));
}

TEST_F(WaitingLabels, WaitNoLongerWhenAnotherOneIsRenamedSo) {
  site.label("gate", run.place(1));
  const msg::OperatorRequest dock = give("dock", held.place(2));
  msg::OperatorRequest rename = site.request(Kind::label_rename);
  rename.label = "gate";
  rename.new_label = "dock";
  EXPECT_EQ(site.ask(rename).outcome, msg::Outcome::done);
  expect_dropped(dock, "calls gate so from now on");
  site.hand_in(r1, held.next(4));
  EXPECT_EQ(labels().at("dock"), run.place(1));
}

TEST_F(WaitingLabels, AreDroppedWhenTheirRunIsRefused) {
  const msg::OperatorRequest dock = give("dock", held.place(6));
  restart();
  Handed wrong = held.next(4);
  wrong.batch.places[1].content.size = 0;
  site.send_batch(r1, wrong.batch);
  expect_dropped(dock, "its run is not taken into the map");
  restart();
  EXPECT_FALSE(reply_to(dock));
}

TEST_F(WaitingLabels, AreDroppedWhenTheirRunEndsWithoutTheirPlace) {
  const msg::OperatorRequest dock = give("dock", held.place(6));
  site.hand_in(r1, held.next(4));
  EXPECT_THAT(site.disk->awaited_labels, SizeIs(1)) << "more may come";
  site.hand_in(r1, held.seal());
  expect_dropped(dock, "nothing more comes of its run");
}

TEST_F(WaitingLabels, AreDroppedWithTheirRobot) {
  const msg::OperatorRequest dock = give("dock", held.place(2));
  site.pass(60s);
  msg::OperatorRequest forget = site.request(Kind::forget);
  forget.robot = "r1";
  EXPECT_EQ(site.ask(forget).outcome, msg::Outcome::done);
  expect_dropped(dock, "was forgotten");
}

TEST_F(WaitingLabels, AreRefusedByAStoreThatTakesNothing) {
  site.disk->faults.full = true;
  const msg::OperatorRequest dock = give("dock", held.place(2));
  expect_dropped(dock, "dock cannot wait for it");
  site.disk->faults.full = false;
  site.hand_in(r1, held.next(4));
  EXPECT_THAT(labels(), IsEmpty());
}

TEST_F(WaitingLabels, WaitOnWhileTheStoreDoesNotTakeThem) {
  const msg::OperatorRequest dock = give("dock", held.place(2));
  site.disk->awaited_labels.at("dock").place = run.place(1);
  site.disk->faults.fail_next = 2;  // the note of the start, and the label
  restart();
  EXPECT_EQ(reply_to(dock)->outcome, msg::Outcome::under_way);
  EXPECT_THAT(site.disk->awaited_labels, SizeIs(1));
  site.pass(11s);
  EXPECT_EQ(reply_to(dock)->outcome, msg::Outcome::done);
  EXPECT_EQ(labels().at("dock"), run.place(1));
}

TEST_F(WaitingLabels, AreBoundedInNumber) {
  for (std::size_t at = 0; at < AwaitedLabels::kMost; ++at) {
    const std::string name = "l" + std::to_string(at);
    site.disk->awaited_labels[name] = {name, held.place(1), r1.id, site.client.id, 1000 + at, "anna"};
  }
  restart();
  msg::OperatorRequest here = site.request(Kind::label_here);
  here.robot = "r1";
  here.label = "dock";
  const msg::OperatorReply reply = site.ask(here);
  EXPECT_EQ(reply.outcome, msg::Outcome::refused);
  EXPECT_THAT(reply.message, HasSubstr("1000 labels wait"));
  EXPECT_THAT(reply.message, HasSubstr("weft map unlabel"));
  give("l7", held.place(2));
  EXPECT_EQ(site.disk->awaited_labels.at("l7").place, held.place(2)) << "one that waits may wait for another place";
}

}  // namespace
}  // namespace weft::server::test
