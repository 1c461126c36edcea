#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "tests/server/run_with_bypass.hpp"

/// Tests edits of the map, and what becomes of those who drive on what is edited.
namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

struct Edits : RunWithBypass {
  msg::OperatorReply edit(Kind kind, const Removal& what) {
    msg::OperatorRequest request = site.request(kind);
    request.work.what = what;
    return site.ask(request);
  }
  msg::OperatorReply to_revision(Kind kind, Revision revision) {
    msg::OperatorRequest request = site.request(kind);
    request.work.revision = revision;
    return site.ask(request);
  }
  msg::OperatorReply take_out(std::uint32_t first, std::uint32_t last) {
    return edit(Kind::undo, {{{run.id(), first, last}}, {}});
  }
  std::uint64_t places() { return site.service().snapshot().place_count(); }
  Revision revision() { return site.service().snapshot().revision(); }
  /// Has r2 stand there, stopped by an operator: it makes no way.
  void stop_in_the_way(const PlaceId& place) {
    site.arrive(r2, place);
    site.stand_stopped(r2, place);
  }
  Route start() {
    site.say(site.state(r1, run.place(0)));
    site.send_goal(1, "dock", "r1");
    site.pass(1s);
    const Route route = site.order();
    site.progress(r1, route, msg::RoutePhase::driving);
    return route;
  }

  Peer r2{.id = robot_id(2), .name = "r2"};
};

TEST_F(Edits, AnExperienceGoesAndComesBack) {
  msg::OperatorRequest request = site.request(Kind::undo);
  request.label = to_string(bypass.id());
  const msg::OperatorReply gone = site.ask(request);
  EXPECT_EQ(gone.outcome, msg::Outcome::done) << gone.message;
  EXPECT_EQ(gone.revision, revision());
  EXPECT_EQ(places(), 40U);
  EXPECT_EQ(site.service().snapshot().stitch_count(), 0U);
  const msg::OperatorReply back = to_revision(Kind::undo, gone.revision);
  EXPECT_EQ(back.outcome, msg::Outcome::done) << back.message;
  EXPECT_EQ(places(), 46U);
  EXPECT_EQ(site.service().snapshot().stitch_count(), 2U);
  EXPECT_EQ(to_revision(Kind::undo, gone.revision).outcome, msg::Outcome::refused) << "nothing is left to undo";
  EXPECT_THAT(site.events_of("map.undo"), SizeIs(2));
}

TEST_F(Edits, StretchesAreApartUntilThatIsUndone) {
  const Removal floors{{{bypass.id(), 1, 4}, {run.id(), 12, 18}}, {}};
  const Apart apart = ordered({floors.places[0], floors.places[1]});
  const auto before = site.service().snapshot().shared_labels();
  const msg::OperatorReply done = edit(Kind::apart, floors);
  EXPECT_EQ(done.outcome, msg::Outcome::done) << done.message;
  EXPECT_EQ(done.revision, revision());
  EXPECT_TRUE(are_apart(site.service().snapshot(), run.place(15), bypass.place(2)));
  EXPECT_EQ(site.service().snapshot().shared_labels(), before) << "nobody's window has changed";
  EXPECT_THAT(site.events_of("map.apart"), ElementsAre(HasSubstr("different floors")));
  EXPECT_EQ(edit(Kind::apart, floors).outcome, msg::Outcome::refused) << "they are so already";
  site.restart();
  EXPECT_EQ(site.service().snapshot().aparts(), Snapshot::Aparts{apart});
  const msg::OperatorReply undone = to_revision(Kind::undo, done.revision);
  EXPECT_EQ(undone.outcome, msg::Outcome::done) << undone.message;
  EXPECT_TRUE(site.service().snapshot().aparts().empty());
  EXPECT_EQ(to_revision(Kind::undo, done.revision).outcome, msg::Outcome::refused) << "nothing is left to undo";
  EXPECT_EQ(to_revision(Kind::undo, undone.revision).outcome, msg::Outcome::done);
  EXPECT_EQ(site.service().snapshot().aparts(), Snapshot::Aparts{apart});
  EXPECT_EQ(to_revision(Kind::rollback, undone.revision).outcome, msg::Outcome::done);
  EXPECT_TRUE(site.service().snapshot().aparts().empty());
}

TEST_F(Edits, StretchesThatCannotBeApartAreRefused) {
  const Revision before = revision();
  for (const std::vector<Stretch>& named : {std::vector<Stretch>{},
                                            {{run.id(), 1, 2}},
                                            {{run.id(), 1, 2}, {run.id(), 1, 2}},
                                            {{run.id(), 1, 5}, {run.id(), 4, 9}},
                                            {{run.id(), 1, 5}, {bypass.id(), 0, 99}},
                                            {{run.id(), 1, 5}, {ExperienceId{77}, 0, 1}}}) {
    const msg::OperatorReply reply = edit(Kind::apart, {named, {}});
    EXPECT_EQ(reply.outcome, msg::Outcome::refused) << reply.message;
    EXPECT_GT(reply.message.size(), 20U);
  }
  EXPECT_EQ(revision(), before);
}

TEST_F(Edits, WhatWouldBeDoneIsSaidAndNotDone) {
  msg::OperatorRequest request = site.request(Kind::quarantine);
  request.work.what = {{{run.id(), 5, 9}}, {}};
  request.work.only_say = true;
  const Revision before = revision();
  const msg::OperatorReply said = site.ask(request);
  EXPECT_EQ(said.outcome, msg::Outcome::done);
  EXPECT_THAT(said.message, HasSubstr("5 places out of the map"));
  EXPECT_EQ(revision(), before);
  EXPECT_EQ(said.revision, Revision{});
}

TEST_F(Edits, RollbackIsARevisionThatCanBeUndone) {
  const Revision whole = revision();
  take_out(5, 9);
  site.label("gate", run.place(3));
  const msg::OperatorReply back = to_revision(Kind::rollback, whole);
  EXPECT_EQ(back.outcome, msg::Outcome::done) << back.message;
  EXPECT_EQ(places(), 46U);
  EXPECT_FALSE(site.service().snapshot().labels().contains("gate"));
  EXPECT_GT(revision(), whole);
  EXPECT_EQ(to_revision(Kind::undo, back.revision).outcome, msg::Outcome::done);
  EXPECT_EQ(places(), 41U);
  EXPECT_TRUE(site.service().snapshot().labels().contains("gate"));
  EXPECT_EQ(to_revision(Kind::undo, back.revision).outcome, msg::Outcome::refused) << "more has come since";
  EXPECT_EQ(to_revision(Kind::rollback, Revision{revision().value + 5}).outcome, msg::Outcome::refused);
}

TEST_F(Edits, ALabelThatWasMovedGoesBack) {
  site.label("dock", run.place(5));
  const Revision moved = revision();
  EXPECT_EQ(to_revision(Kind::undo, moved).outcome, msg::Outcome::done);
  EXPECT_EQ(site.service().snapshot().labels().at("dock"), run.place(39));
}

/// Returns a batch by which the robot says what it has learned of these places of the run.
Handed learned_by(Peer& robot, std::uint64_t experience, std::uint64_t sequence, const std::vector<Place>& known) {
  Handed handed;
  handed.batch.experience = {experience};
  handed.batch.sequence = sequence;
  handed.batch.robot = robot.id;
  handed.batch.name = "lessons";
  handed.batch.method = "marks";
  for (const Place& place : known) {
    handed.contents.emplace_back(Bytes(50, static_cast<std::uint8_t>(experience + place.id.index)));
    Place anew = place;
    ++anew.entity_version;
    anew.content = {hash_bytes(handed.contents.back()), handed.contents.back().size()};
    anew.robot = robot.id;
    handed.batch.learned.push_back(anew);
  }
  return handed;
}

TEST_F(Edits, WhatWasLearnedOnADriveIsOneRevisionThatCanBeUndone) {
  site.arrive(r2, std::nullopt);
  const auto known = [&](std::uint32_t index) { return *site.service().snapshot().place(run.place(index)); };
  const Place before = known(3);
  const Handed lessons = learned_by(r2, 77, 1, {known(3), known(4)});
  site.hand_in(r2, lessons);
  EXPECT_EQ(known(3), lessons.batch.learned[0]);
  const Revision learned = revision();
  site.hand_in(r2, learned_by(r2, 77, 2, {known(4)}));
  const Place newest = known(4);

  const msg::OperatorReply undone = to_revision(Kind::undo, learned);
  EXPECT_EQ(undone.outcome, msg::Outcome::done) << undone.message;
  EXPECT_THAT(undone.message, HasSubstr("1 place known as before"));
  EXPECT_EQ(known(3).content, before.content);
  EXPECT_EQ(known(3).entity_version, 3U) << "a lesson upon the undone one comes too late";
  EXPECT_EQ(known(4), newest) << "somebody has learned more since";
  EXPECT_EQ(to_revision(Kind::undo, undone.revision).outcome, msg::Outcome::done) << "an undo can be undone";
  EXPECT_EQ(known(3).content, lessons.batch.learned[0].content);
  site.restart();
  EXPECT_EQ(known(3).content, lessons.batch.learned[0].content);
}

TEST_F(Edits, ContentsOfAMapOfThePastAreLentAgain) {
  site.arrive(r2, std::nullopt);
  const Place before = *site.service().snapshot().place(run.place(3));
  site.hand_in(r2, learned_by(r2, 77, 1, {before}));
  const Revision learned = revision();
  site.restart();
  site.arrive(r2, std::nullopt);
  EXPECT_EQ(to_revision(Kind::undo, learned).outcome, msg::Outcome::done);
  site.hush();
  site.say(msg::ContentRequest{.header = r2.header(), .to = {}, .items = {{before.content.hash, 0}}});
  EXPECT_THAT(site.heard<msg::Chunk>(), SizeIs(1));
}

TEST_F(Edits, OfTwoRobotsThatLearnBesideEachOtherTheFirstCounts) {
  site.arrive(r2, std::nullopt);
  const Place known = *site.service().snapshot().place(run.place(3));
  const Place other = *site.service().snapshot().place(run.place(5));
  site.hand_in(r1, learned_by(r1, 76, 1, {known}));
  const Place first = *site.service().snapshot().place(run.place(3));
  const Handed late = learned_by(r2, 77, 1, {known, other});
  site.hand_in(r2, late);
  EXPECT_EQ(site.last<msg::BatchAck>()->durable_through, 1U) << "that is no fault of the second one's";
  EXPECT_EQ(*site.service().snapshot().place(run.place(3)), first);
  EXPECT_EQ(*site.service().snapshot().place(run.place(5)), late.batch.learned[1]);
  EXPECT_FALSE(site.disk->contents.contains(late.batch.learned[0].content.hash)) << "nobody names it";
  EXPECT_EQ(site.counted("intake: places learned too late"), 1U);
}

TEST_F(Edits, NonsenseIsRefusedByName) {
  EXPECT_THAT(edit(Kind::undo, {{{ExperienceId{99}, 0, 5}}, {}}).message, HasSubstr("is in the map"));
  EXPECT_EQ(edit(Kind::undo, {}).outcome, msg::Outcome::refused);
  EXPECT_EQ(to_revision(Kind::undo, Revision{4711}).outcome, msg::Outcome::refused);
  msg::OperatorRequest request = site.request(Kind::quarantine);
  request.label = "nowhere";
  EXPECT_THAT(site.ask(request).message, HasSubstr("no experience nowhere"));
  EXPECT_EQ(places(), 46U);
}

TEST_F(Edits, NothingIsChangedThatCannotBeStored) {
  site.disk->faults.full = true;
  const msg::OperatorReply reply = take_out(5, 9);
  EXPECT_EQ(reply.outcome, msg::Outcome::failed);
  EXPECT_EQ(places(), 46U);
  site.disk->faults.full = false;
  EXPECT_EQ(take_out(5, 9).outcome, msg::Outcome::done);
  EXPECT_EQ(places(), 41U);
}

TEST_F(Edits, ABatchOfAnExperienceWhoseEndIsOutIsRefusedAndSaysWhatToDo) {
  take_out(35, 39);
  site.hush();
  site.hand_in(r1, run.next(2));
  EXPECT_THAT(site.last<msg::BatchAck>().value().refusal, HasSubstr("was taken out of the map; begin a new one"));
}

// Gadd & Newman's route of two experiences: beyond what is released it may change without the robot noticing.
TEST_F(Edits, WhatIsAheadOfTheReleasedPointIsPlannedAnew) {
  stop_in_the_way(run.place(8));
  const Route first = start();
  ASSERT_LT(first.released, 8U) << "r2 stands in the way";
  site.hush();
  EXPECT_EQ(take_out(14, 16).outcome, msg::Outcome::done);
  site.pass(1s);
  const Route next = site.order();
  EXPECT_EQ(next.id, first.id);
  EXPECT_EQ(next.version, first.version + 1);
  EXPECT_EQ(next.released, first.released);
  EXPECT_TRUE(std::equal(next.places.begin(), next.places.begin() + next.released + 1, first.places.begin()))
      << "the robot goes on without stopping";
  EXPECT_THAT(next.places, testing::Contains(bypass.place(3)));
  EXPECT_EQ(next.places.back(), run.place(39));
  EXPECT_EQ(next.relations.size() + 1, next.places.size());
  EXPECT_EQ(site.disk->occupancies.at(r1.id).held.version, next.version) << "what it holds is of the new version";
  EXPECT_THAT(site.events_of("goal.planned_anew"), SizeIs(1));
  site.progress(r1, next, msg::RoutePhase::driving, 2);
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
}

TEST_F(Edits, WithoutAnotherWayTheRobotStopsAtItsReleasedPointAndSaysWhy) {
  stop_in_the_way(run.place(8));
  const Route first = start();
  site.hush();
  take_out(25, 26);
  site.pass(1s);
  const Route cut = site.order();
  EXPECT_EQ(cut.version, first.version);
  EXPECT_EQ(cut.released, first.released);
  EXPECT_THAT(cut.reason, HasSubstr("the map was changed ahead of r1"));
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  // r2 goes away: nothing more is released towards what is gone.
  site.say(site.state(r2, bypass.place(3)));
  site.pass(2s);
  EXPECT_EQ(site.order().released, first.released);
  // It comes back: the goal goes on.
  site.hush();
  to_revision(Kind::undo, revision());
  site.pass(2s);
  EXPECT_GT(site.order().released, first.released);
}

TEST_F(Edits, WhatTheRobotDrivesOnIsRecalledAndPlannedFromWhereItStands) {
  const Route first = start();
  ASSERT_GT(first.released, 30U);
  site.hush();
  EXPECT_EQ(take_out(14, 16).outcome, msg::Outcome::done);
  const Route recalled = site.order();
  EXPECT_TRUE(recalled.ended);
  EXPECT_EQ(recalled.id, first.id);
  EXPECT_EQ(site.goal(1).state, GoalState::executing) << "the goal is not over";
  EXPECT_EQ(site.disk->occupancies.at(r1.id).held.id, first.id) << "held until it says where it stands";
  site.hush();
  msg::RobotState stands = site.state(r1, run.place(4));
  site.say(stands);
  site.pass(1s);
  const Route next = site.order();
  EXPECT_FALSE(next.ended);
  EXPECT_NE(next.id, first.id) << "the robot takes no more orders for a route that was ended";
  EXPECT_EQ(next.version, first.version + 1);
  EXPECT_EQ(next.places.front(), run.place(4));
  EXPECT_THAT(next.places, testing::Contains(bypass.place(3)));
  site.progress(r1, next, msg::RoutePhase::arrived, next.released);
  EXPECT_EQ(site.goal(1).state, GoalState::succeeded);
}

/// Takes the whole run out from under a robot with a goal, and brings it back.
TEST_F(Edits, ARobotWhoseGroundWasOutSaysSoMayBeToldToLocaliseAndGoesOn) {
  start();
  take_out(0, 39);
  msg::RobotState stands = site.state(r1, run.place(4));
  site.say(stands);
  site.pass(2s);
  EXPECT_THAT(site.goal(1).history.back().cause, HasSubstr("r1 stands on a place that was taken out of the map"));
  stands = site.state(r1, std::nullopt);
  site.say(stands);
  site.pass(2s);
  EXPECT_THAT(site.goal(1).history.back().cause, HasSubstr("r1 does not know where it is"));
  msg::OperatorRequest localise = site.request(Kind::localise);
  localise.robot = "r1";
  site.hush();
  site.say(localise);
  ASSERT_TRUE(site.last<msg::AgentCommand>()) << "with a goal";
  EXPECT_EQ(site.last<msg::AgentCommand>()->kind, msg::AgentCommand::Kind::localise);
  EXPECT_EQ(to_revision(Kind::undo, revision()).outcome, msg::Outcome::done);
  site.hush();
  site.say(site.state(r1, run.place(4)));
  site.pass(2s);
  ASSERT_TRUE(site.last<msg::RouteOrder>());
  EXPECT_EQ(site.order().places.front(), run.place(4));
  EXPECT_EQ(site.order().places.back(), run.place(39));
}

TEST_F(Edits, ARestartedServerRecallsToo) {
  const Route first = start();
  site.disk->faults.full = false;
  take_out(14, 16);
  site.hush();
  site.restart();
  site.arrive(r1, std::nullopt);
  site.pass(5s);
  const std::vector<msg::RouteOrder> orders = site.heard<msg::RouteOrder>();
  ASSERT_FALSE(orders.empty());
  EXPECT_TRUE(orders.front().route.ended);
  EXPECT_EQ(orders.front().route.id, first.id);
}

// Two runs over one floor: who holds a place of the one is in the way on the other, also when the one is out.
TEST_F(Edits, WhatIsHeldStaysInTheWayWhenItIsOutOfTheMap) {
  site.arrive(r2, bypass.place(2));
  site.arrive(r1, run.place(0));
  msg::OperatorRequest request = site.request(Kind::quarantine);
  request.label = to_string(bypass.id());
  ASSERT_EQ(site.ask(request).outcome, msg::Outcome::done);
  // A run that was taught along the bypass before it went: r2 still stands there.
  Site& map = site;
  TaughtRun beside(r1, 12);
  Handed again = beside.next(3);
  again.batch.edges.push_back(stitch(bypass.place(2), beside.place(1), 0.0, 0.1));
  map.hand_in(r1, again);
  ASSERT_EQ(map.service().snapshot().experience(beside.id())->stitches.size(), 0U);
  EXPECT_EQ(map.disk->occupancies.at(r2.id).held.places.front(), bypass.place(2)) << "held, whatever the map says";
  map.restart();
  map.arrive(r2, std::nullopt);
  EXPECT_EQ(map.disk->occupancies.at(r2.id).held.places.front(), bypass.place(2));
  EXPECT_TRUE(map.events_of("traffic.ground_unknown").empty())
      << "the ground is known from the revision it was given";
}

TEST_F(Edits, AStandingRobotOnGroundThatIsOutBlocksTheWayPastIt) {
  // r2 stands on the bypass, 0.3 m beside the run; nobody is released past it, before and after the bypass is out.
  TaughtRun close(r1, 13);
  Handed handed = close.next(1);
  handed.batch.edges.push_back(stitch(run.place(8), close.place(0), 0.0, 0.3));
  site.hand_in(r1, handed);
  site.arrive(r2, close.place(0));
  msg::OperatorRequest request = site.request(Kind::quarantine);
  request.label = to_string(close.id());
  ASSERT_EQ(site.ask(request).outcome, msg::Outcome::done);
  const Route route = start();
  EXPECT_LT(route.released, 8U);
  site.hush();
  site.restart();
  site.arrive(r1, run.place(0));
  site.pass(5s);
  EXPECT_LT(site.goal(1).route_version, 99U);
  for (const msg::RouteOrder& one : site.heard<msg::RouteOrder>()) EXPECT_LT(one.route.released, 8U);
}

}  // namespace
}  // namespace weft::server::test
