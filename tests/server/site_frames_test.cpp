#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/one_run.hpp"

/// Registers floor plans at a server, and looks where robots stand on them.
namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct ServerSiteFrames : OneRun {
  Pick pick(std::uint32_t place, double x, double y) const {
    Pick made;
    made.name = "p" + std::to_string(place);
    made.place = run.place(place);
    made.on_plan = {x, y};
    return made;
  }
  msg::OperatorReply ask(const msg::OperatorRequest& request) {
    site.hush();
    site.say(request);
    site.pass(2s);
    return site.last<msg::OperatorReply>().value();
  }
  msg::OperatorReply put(const Registration& registration, bool only_say = false) {
    msg::OperatorRequest request = site.request(Kind::plan_register);
    request.registration = registration;
    request.work.only_say = only_say;
    return ask(request);
  }
  msg::OperatorReply go_to(double x, double y, const std::string& plan = "") {
    msg::OperatorRequest request = site.request(Kind::goal_send);
    request.goal = goal_id(++goals);
    request.on_plan = msg::PointOnPlan{plan, {x, y}};
    request.no_return = true;
    return ask(request);
  }
  const Snapshot::Registrations& registrations() { return site.service().snapshot().registrations(); }

  /// Lays the run, which leads straight on, along the plan's y from (10, 0) on.
  Registration hall{"hall", {}, {pick(0, 10.0, 0.0), pick(40, 10.0, 20.0)}};
  std::uint8_t goals = 0;
};

TEST_F(ServerSiteFrames, AreStoredAndSurviveARestartAndAnUndo) {
  const msg::OperatorReply done = put(hall);
  EXPECT_EQ(done.outcome, msg::Outcome::done) << done.message;
  EXPECT_THAT(done.message, HasSubstr("plan hall by 2 picks: p0, p40"));
  EXPECT_THAT(done.message, HasSubstr("60 of 60 places lie on the plan"));
  EXPECT_THAT(site.events_of("map.register"), ElementsAre(HasSubstr("plan hall registered")));
  EXPECT_THAT(put(hall).message, HasSubstr("is registered so already"));
  site.restart();
  EXPECT_EQ(registrations().at("hall"), hall);
  msg::OperatorRequest undo = site.request(Kind::undo);
  undo.work.revision = done.revision;
  EXPECT_EQ(ask(undo).outcome, msg::Outcome::done);
  EXPECT_THAT(registrations(), IsEmpty());
}

TEST_F(ServerSiteFrames, ThatDoNotHoldTheMapAreRefusedAndNothingIsStored) {
  EXPECT_THAT(put({"hall", {}, {pick(0, 1.0, 1.0)}}).message, HasSubstr("plan hall: one pick needs a heading"));
  EXPECT_THAT(put({"hall", {}, {pick(0, 1.0, 1.0), pick(1, 1.5, 1.0)}}).message,
              HasSubstr("no two picks lie 1 m apart"));
  EXPECT_THAT(put({"hall", {}, {pick(70, 1.0, 1.0)}}).message, HasSubstr("is not in the map"));
  EXPECT_THAT(put(hall, true).message, HasSubstr("nothing was changed"));
  EXPECT_THAT(registrations(), IsEmpty());
}

TEST_F(ServerSiteFrames, AreRemovedByNameOrWhenItIsTheOnlyOne) {
  const auto remove = [&](const std::string& plan) {
    msg::OperatorRequest request = site.request(Kind::plan_remove);
    request.registration.plan = plan;
    return ask(request);
  };
  EXPECT_THAT(remove("").message, HasSubstr("the map has no registered plan; it has none"));
  put(hall);
  Registration yard = hall;
  yard.plan = "yard";
  put(yard);
  EXPECT_THAT(remove("").message, HasSubstr("several plans are registered"));
  EXPECT_THAT(remove("shed").message, HasSubstr("no registered plan shed; known: hall, yard"));
  EXPECT_EQ(remove("hall").outcome, msg::Outcome::done);
  EXPECT_EQ(remove("").outcome, msg::Outcome::done);
  EXPECT_THAT(registrations(), IsEmpty());
}

TEST_F(ServerSiteFrames, TellWhereARobotStands) {
  site.say(site.state(r1, run.place(20)));
  EXPECT_EQ(site.row("r1").plan, "");
  put(hall);
  site.say(site.state(r1, run.place(20)));
  const msg::RobotRow row = site.row("r1");
  EXPECT_EQ(row.plan, "hall");
  EXPECT_NEAR(row.plan_from_robot.x, 10.0, 1e-6);
  EXPECT_NEAR(row.plan_from_robot.y, 10.0, 1e-6);
  EXPECT_NEAR(row.plan_from_robot.heading, 1.5708, 1e-3);
}

TEST_F(ServerSiteFrames, ThatWereReplacedTellNoRobotsPlaceAnyMore) {
  put(hall);
  site.say(site.state(r1, run.place(20)));
  ASSERT_EQ(site.row("r1").plan, "hall");
  Registration corrected = hall;
  for (Pick& pick : corrected.picks) pick.on_plan.x() += 5.0;
  msg::OperatorRequest request = site.request(Kind::plan_register);
  request.registration = corrected;
  site.hush();
  site.say(request);
  for (int turns = 0; turns < 100 && !site.last<msg::OperatorReply>(); ++turns) site.pass(500us);
  ASSERT_EQ(registrations().at("hall"), corrected);
  EXPECT_EQ(site.row("r1").plan, "") << "it is being worked out";
  site.pass(2s);
  site.say(site.state(r1, run.place(20)));
  EXPECT_EQ(site.row("r1").plan, "hall");
  EXPECT_NEAR(site.row("r1").plan_from_robot.x, 15.0, 1e-6);
}

TEST_F(ServerSiteFrames, ThatAnUndoWouldBringBackAreRefusedWhereTheMapHasTheMost) {
  for (std::size_t i = 0; i < kMostRegistrations; ++i) {
    Registration one = hall;
    one.plan = "hall" + std::to_string(i);
    ASSERT_EQ(put(one).outcome, msg::Outcome::done);
  }
  msg::OperatorRequest remove = site.request(Kind::plan_remove);
  remove.registration.plan = "hall7";
  const Revision removed = ask(remove).revision;
  ASSERT_EQ(put(hall).outcome, msg::Outcome::done);
  const auto undo = [&] {
    msg::OperatorRequest request = site.request(Kind::undo);
    request.work.revision = removed;
    return ask(request);
  };
  const msg::OperatorReply refused = undo();
  EXPECT_EQ(refused.outcome, msg::Outcome::refused);
  EXPECT_THAT(refused.message, HasSubstr("the map would have 21 registered plans, at most 20: remove one"));
  EXPECT_THAT(registrations(), SizeIs(kMostRegistrations));
  remove = site.request(Kind::plan_remove);
  remove.registration.plan = "hall8";
  ASSERT_EQ(ask(remove).outcome, msg::Outcome::done);
  EXPECT_EQ(undo().outcome, msg::Outcome::done);
  EXPECT_TRUE(registrations().contains("hall7"));
}

TEST_F(ServerSiteFrames, AreShownWithWhatBecameOfEachPick) {
  put(hall);
  const msg::QueryReply reply = site.read(msg::Query::Kind::registrations);
  ASSERT_THAT(reply.registrations, SizeIs(1));
  const msg::RegistrationRow& row = reply.registrations[0];
  EXPECT_EQ(row.registration, hall);
  EXPECT_EQ(row.problem, "");
  EXPECT_EQ(row.places, 60U);
  EXPECT_EQ(row.all_places, 60U);
  ASSERT_THAT(row.picks, SizeIs(2));
  EXPECT_EQ(row.picks[0].state, msg::RegistrationRow::PickState::counts);
  EXPECT_NEAR(row.picks[0].off_m, 0.0, 1e-6);
}

TEST_F(ServerSiteFrames, AreWorkedOutAnewAfterAnEdit) {
  put(hall);
  msg::OperatorRequest out = site.request(Kind::quarantine);
  out.work.what.places = {{run.place(40).experience, 40, 40}};
  EXPECT_EQ(ask(out).outcome, msg::Outcome::done);
  const msg::RegistrationRow row = site.read(msg::Query::Kind::registrations).registrations.at(0);
  EXPECT_EQ(row.registration, hall);
  EXPECT_THAT(row.problem, HasSubstr("one pick needs a heading"));
}

TEST_F(ServerSiteFrames, TakeAGoalToTheNearestPlace) {
  EXPECT_THAT(go_to(10.0, 5.0).message, HasSubstr("no floor plan is registered"));
  put(hall);
  site.say(site.state(r1, run.place(0)));
  const msg::OperatorReply sent = go_to(10.2, 5.1);
  EXPECT_TRUE(sent.outcome == msg::Outcome::done || sent.outcome == msg::Outcome::accepted) << sent.message;
  EXPECT_EQ(site.goal(goals).to, run.place(10));
  EXPECT_EQ(site.goal(goals).label, "10.20,5.10");
  EXPECT_THAT(go_to(12.0, 5.0).message, HasSubstr("no place lies within 0.5 m of 12.00,5.00; the nearest is"));
  EXPECT_THAT(go_to(10.0, 5.0, "yard").message, HasSubstr("no floor plan yard is registered; known: hall"));
}

}  // namespace
}  // namespace weft::server::test
