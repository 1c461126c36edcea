#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/run_with_bypass.hpp"

/// Tests what rules do to routes and releases.
namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct RuledTraffic : RunWithBypass {
  msg::OperatorReply close(const std::string& name, std::uint32_t first, std::uint32_t last) {
    return site.put_rule({.name = name, .spans = {{run.place(first), run.place(last)}}});
  }
  msg::OperatorReply remove(const std::string& name) {
    msg::OperatorRequest request = site.request(Kind::rule_remove);
    request.rule.name = name;
    return site.ask(request);
  }
  /// Returns what r1 says when its base has stopped it on a route.
  msg::RobotState stopped_on(const Route& route, Safety safety) {
    msg::RobotState state = site.driving(r1, route, run.place(5));
    state.mode = msg::RobotMode::stopped;
    state.safety = safety;
    return state;
  }
  Route start() {
    site.say(site.state(r1, run.place(0)));
    site.send_goal(1, "dock", "r1");
    site.pass(1s);
    return site.order();
  }
};

TEST_F(RuledTraffic, RoutesLeadRoundWhatIsClosed) {
  close("shut", 14, 16);
  const Route route = start();
  EXPECT_THAT(route.places, Contains(bypass.place(2)));
  EXPECT_EQ(route.released + 1, route.places.size());
}

TEST_F(RuledTraffic, AGoalThatOnlyLeadsThroughItWaitsAndNamesTheRule) {
  close("shut", 30, 32);
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "dock", "r1");
  site.pass(1s);
  EXPECT_FALSE(site.last<msg::RouteOrder>());
  EXPECT_EQ(site.goal(1).state, GoalState::pending);
  EXPECT_THAT(site.why(1), HasSubstr("rule shut bars the way"));
  remove("shut");
  site.pass(1s);
  EXPECT_EQ(site.order().places.back(), run.place(39));
}

TEST_F(RuledTraffic, WhatIsReleasedStaysAndWhatLiesBeyondIsPlannedAnew) {
  Peer r2{.id = robot_id(2), .name = "r2"};
  site.arrive(r2, std::nullopt);
  site.stand_stopped(r2, run.place(12));
  const Route before = start();
  ASSERT_LT(before.released, 12U) << "r2 stands in the way";
  close("shut", 14, 16);
  site.pass(1s);
  const Route after = site.order();
  EXPECT_EQ(after.version, before.version + 1);
  EXPECT_EQ(after.released, before.released);
  EXPECT_THAT(after.places, Contains(bypass.place(2)));
}

TEST_F(RuledTraffic, ARobotThatWasReleasedThroughDrivesOn) {
  const Route before = start();
  ASSERT_EQ(before.released, 39U);
  close("shut", 14, 16);
  site.pass(1s);
  EXPECT_EQ(site.order().version, before.version);
  EXPECT_FALSE(site.order().ended);
}

TEST_F(RuledTraffic, WithoutAnotherWayItDrivesToItsReleasedPointAndSaysTheRule) {
  Peer r2{.id = robot_id(2), .name = "r2"};
  site.arrive(r2, std::nullopt);
  site.stand_stopped(r2, run.place(25));
  const Route before = start();
  ASSERT_LT(before.released, 25U);
  close("shut", 30, 32);
  site.pass(1s);
  EXPECT_THAT(site.why(1), HasSubstr("rule shut bars the way"));
  EXPECT_EQ(site.order().released, before.released);
  site.progress(r1, site.order(), msg::RoutePhase::waiting, before.released);
  site.pass(1s);
  const msg::RobotWait wait = site.row("r1").wait;
  EXPECT_EQ(wait.at, run.place(before.released));
  EXPECT_EQ(wait.rule, "shut");
  EXPECT_EQ(wait.needs, run.place(30));
  remove("shut");
  site.stand_stopped(r2, run.place(39));
  site.pass(2s);
  EXPECT_EQ(site.order().id, before.id);
  EXPECT_GT(site.order().released, before.released);
}

TEST_F(RuledTraffic, WhoHasNoRouteYetIsSaidToWaitForTheRuleThatBarsIt) {
  Peer r2{.id = robot_id(2), .name = "r2"};
  site.arrive(r2, std::nullopt);
  site.stand_stopped(r2, run.place(2));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "dock", "r1");
  ASSERT_FALSE(site.order_to(r1));
  close("shut", 30, 32);
  site.pass(3s);
  const msg::RobotWait wait = site.row("r1").wait;
  EXPECT_EQ(wait.at, run.place(0));
  EXPECT_EQ(wait.rule, "shut");
  EXPECT_EQ(wait.needs, run.place(30));
}

TEST_F(RuledTraffic, AHeldZoneEndsReleasesUntilItIsLetGo) {
  site.put_rule({.name = "wait", .kind = RuleKind::hold, .spans = {{run.place(22), run.place(26)}}});
  const Route route = start();
  EXPECT_EQ(route.released, 21U);
  EXPECT_THAT(site.why(1), HasSubstr("r1 waits until rule wait lets it on"));
  site.progress(r1, route, msg::RoutePhase::waiting);
  site.pass(3s);
  const msg::RobotWait wait = site.row("r1").wait;
  EXPECT_EQ(wait.rule, "wait");
  EXPECT_EQ(wait.needs, run.place(22));
  EXPECT_THAT(wait.held_by, SizeIs(0));
  remove("wait");
  site.pass(1s);
  EXPECT_EQ(site.order().released, 39U);
  EXPECT_THAT(site.why(1), HasSubstr("rule wait lets it on"));
}

TEST_F(RuledTraffic, AHeldRobotIsReleasedNoFarther) {
  Peer r2{.id = robot_id(2), .name = "r2"};
  site.arrive(r2, std::nullopt);
  site.stand_stopped(r2, run.place(25));
  const Route before = start();
  msg::OperatorRequest request = site.request(Kind::hold);
  request.robot = "r1";
  site.ask(request);
  site.stand_stopped(r2, run.place(39));
  site.pass(2s);
  EXPECT_EQ(site.order().released, before.released);
  EXPECT_THAT(site.why(1), HasSubstr("r1 is held by"));
  request = site.request(Kind::unhold);
  request.robot = "r1";
  site.ask(request);
  site.pass(1s);
  EXPECT_GT(site.order().released, before.released);
}

TEST_F(RuledTraffic, AnAgentThatDoesNotKnowLimitsIsNotReleasedIntoThem) {
  site.put_rule({.name = "slow", .kind = RuleKind::speed, .value = 0.3, .spans = {{run.place(14), run.place(16)}}});
  EXPECT_THAT(start().places, Contains(bypass.place(2)));
}

TEST_F(RuledTraffic, AnAgentThatKeepsLimitsIsToldThemWithItsRoute) {
  r1.knows_limits = true;
  site.arrive(r1, run.place(0));
  site.put_rule({.name = "slow", .kind = RuleKind::speed, .value = 0.5, .spans = {{run.place(14), run.place(16)}}});
  const Route route = start();
  ASSERT_THAT(route.limits, SizeIs(1));
  EXPECT_EQ(route.limits[0], (SpeedLimit{14, 16, 0.5}));
  EXPECT_EQ(route.released, 39U);
}

TEST_F(RuledTraffic, ARouteWithLimitsIsEndedByAnOrderThatItsRobotReads) {
  r1.knows_limits = true;
  site.arrive(r1, run.place(0));
  site.put_rule({.name = "slow", .kind = RuleKind::speed, .value = 0.5, .spans = {{run.place(14), run.place(16)}}});
  const Route route = start();
  ASSERT_THAT(route.limits, SizeIs(1));
  site.progress(r1, route, msg::RoutePhase::driving, 0);
  msg::OperatorRequest cancel = site.request(msg::OperatorRequest::Kind::goal_cancel);
  cancel.goal = route.goal;
  site.ask(cancel);
  site.pass(1s);
  const Route end = site.order();
  EXPECT_TRUE(end.ended);
  EXPECT_EQ(end.id, route.id);
  EXPECT_THAT(end.limits, IsEmpty()) << "of places that it does not have; tests/server/arranged_site.cpp reads it";
}

TEST_F(RuledTraffic, LimitsThatChangeUnderWayComeWithTheNextVersion) {
  r1.knows_limits = true;
  site.arrive(r1, run.place(0));
  const Route before = start();
  ASSERT_THAT(before.limits, SizeIs(0));
  site.put_rule({.name = "slow", .kind = RuleKind::speed, .value = 0.5, .spans = {{run.place(14), run.place(16)}}});
  site.pass(1s);
  const Route after = site.order();
  EXPECT_EQ(after.version, before.version + 1);
  EXPECT_EQ(after.places, before.places);
  EXPECT_EQ(after.released, before.released);
  EXPECT_THAT(after.limits, SizeIs(1));
  site.restart();
  site.arrive(r1, run.place(0));
  site.pass(5s);
  EXPECT_THAT(site.order().limits, SizeIs(1)) << "and stay";
  remove("slow");
  site.pass(1s);
  EXPECT_THAT(site.order().limits, SizeIs(0));
}

TEST_F(RuledTraffic, AnEmergencyStopPausesTheGoalAndOnlyAPersonResumesIt) {
  const Route route = start();
  site.progress(r1, route, msg::RoutePhase::driving);
  msg::RobotState stopped = stopped_on(route, Safety::emergency_stop);
  site.hush();
  site.say(stopped);
  site.pass(2s);
  EXPECT_EQ(site.goal(1).state, GoalState::paused);
  EXPECT_THAT(site.why(1), HasSubstr("told to stop"));
  EXPECT_FALSE(site.last<msg::AgentCommand>()) << "nobody tells it to go on";
}

TEST_F(RuledTraffic, AWordFromBeforeThePersonsResumePausesNothing) {
  const Route route = start();
  site.progress(r1, route, msg::RoutePhase::driving);
  msg::RobotState stopped = stopped_on(route, Safety::emergency_stop);
  site.say(stopped);
  ASSERT_EQ(site.goal(1).state, GoalState::paused);
  msg::RobotState late = stopped;
  late.header = r1.header();
  msg::OperatorRequest resume = site.request(Kind::resume);
  resume.robot = "r1";
  site.say(resume);
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  const msg::AgentCommand command = site.last<msg::AgentCommand>().value();
  msg::AgentReply reply;
  reply.header = r1.header();
  reply.command = command.command;
  reply.done = true;
  site.say(late);
  EXPECT_EQ(site.goal(1).state, GoalState::executing) << "it has not answered yet";
  site.say(reply);
  site.say(late);
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  stopped.header = r1.header();
  site.say(stopped);
  EXPECT_EQ(site.goal(1).state, GoalState::paused) << "it was pressed again";
}

TEST_F(RuledTraffic, AProtectiveStopPausesNothing) {
  const Route route = start();
  site.progress(r1, route, msg::RoutePhase::driving);
  msg::RobotState stopped = stopped_on(route, Safety::protective_stop);
  site.hush();
  site.say(stopped);
  site.pass(2s);
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  EXPECT_FALSE(site.last<msg::AgentCommand>());
}

TEST_F(RuledTraffic, GoalsHaveTheClassOfTheirPlace) {
  site.put_rule({.name = "first", .kind = RuleKind::priority, .value = 6, .label = "dock"});
  start();
  EXPECT_EQ(site.goal(1).priority, 6);
}

}  // namespace
}  // namespace weft::server::test
