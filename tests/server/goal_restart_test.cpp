#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Arranges that r1 has goal 1 and drives when the test begins.
struct GoalRestart : testing::Test {
  GoalRestart() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(40));
    site.label("dock", run.place(39));
    site.say(site.state(r1, run.place(0)));
    site.send_goal(1, "dock", "r1");
    route = site.order();
    site.progress(r1, route, msg::RoutePhase::driving, 2);
    site.say(driving(run.place(2)));
  }
  msg::RobotState driving(const PlaceId& place) { return site.driving(r1, route, place); }
  void restart_agent() {
    r1.incarnation += 1;
    r1.sequence = 0;
    site.arrive(r1, std::nullopt);
  }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
  Route route;
};

TEST_F(GoalRestart, RestartedServerSendsTheSameRouteUntilTheRobotAnswers) {
  site.restart();
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  site.pass(3s);
  ASSERT_GE(site.heard<msg::RouteOrder>().size(), 2U);
  EXPECT_EQ(site.order().id, route.id);
  EXPECT_EQ(site.order().version, route.version);
  EXPECT_EQ(site.order().released, route.released);
  site.arrive(r1, std::nullopt);
  site.say(driving(run.place(8)));
  site.progress(r1, route, msg::RoutePhase::driving, 8);
  site.hush();
  site.pass(3s);
  EXPECT_THAT(site.heard<msg::RouteOrder>(), IsEmpty());
  site.progress(r1, route, msg::RoutePhase::arrived, 39);
  EXPECT_EQ(site.goal(1).state, GoalState::succeeded);
}

TEST_F(GoalRestart, RouteThatWasGivenBackWhileTheServerWasAwayIsPlannedAnew) {
  site.restart();
  site.arrive(r1, std::nullopt);
  // It was told meanwhile where it is, has given its route back for that, and ignores the orders to follow it.
  for (int i = 0; i < 14; ++i) {
    site.say(site.state(r1, run.place(8)));
    site.pass(1s);
  }
  EXPECT_NE(site.order().id, route.id);
  EXPECT_EQ(site.order().places.front(), run.place(8));
}

TEST_F(GoalRestart, GoalThatWaitsSurvivesToo) {
  site.send_goal(2, "dock", "r1");
  site.restart();
  EXPECT_EQ(site.goal(2).state, GoalState::pending);
  site.arrive(r1, std::nullopt);
  site.progress(r1, route, msg::RoutePhase::arrived, 39);
  site.say(site.state(r1, run.place(39)));
  site.pass(1s);
  EXPECT_EQ(site.goal(2).state, GoalState::assigned);
  EXPECT_EQ(site.goal(2).number, 2U);
}

TEST(GoalRestartOnTheWay, AGoalThatNothingIsReleasedOfYetIsDrivenThoughWhatIsHeldIsOfTheOneBefore) {
  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r2"};
  TaughtRun run{r1, 10};
  site.arrive(r1, std::nullopt);
  site.arrive(r2, std::nullopt);
  site.hand_in(r1, run.next(60));
  site.label("middle", run.place(20));
  site.label("end", run.place(59));
  site.say(site.state(r1, run.place(0)));
  // The goal before is the later one by its id.
  site.send_goal(9, "middle", "r1");
  site.progress(r1, site.order(), msg::RoutePhase::arrived, 20);
  site.say(site.state(r1, run.place(20)));
  site.say(site.state(r2, run.place(23)));
  site.send_goal(1, "end", "r1");
  site.pass(1s);
  ASSERT_EQ(site.goal(1).state, GoalState::assigned);
  site.restart();
  for (Peer* const robot : {&r1, &r2}) site.arrive(*robot, std::nullopt);
  site.hush();
  for (int i = 0; i < 20; ++i) {
    site.say(site.state(r1, run.place(20)));
    site.say(site.state(r2, run.place(50)));
    site.pass(1s);
  }
  ASSERT_TRUE(site.order_to(r1));
  EXPECT_EQ(site.order_to(r1)->goal, site.goal(1).id);
  EXPECT_GT(site.order_to(r1)->released, 5U);
}

TEST_F(GoalRestart, RestartedAgentGetsItsRouteFromWhereItStandsAsANewVersion) {
  site.pass(1s);
  restart_agent();
  site.hush();
  site.pass(2s);
  EXPECT_THAT(site.heard<msg::RouteOrder>(), IsEmpty()) << "it does not know where it is";
  EXPECT_EQ(site.disk->occupancies.at(r1.id).held.version, 1U) << "what it held is still held";
  site.say(site.state(r1, run.place(11)));
  site.pass(2s);
  site.say(site.state(r1, run.place(11)));
  ASSERT_TRUE(site.last<msg::RouteOrder>());
  EXPECT_EQ(site.order().id, route.id);
  EXPECT_EQ(site.order().version, 2U);
  EXPECT_EQ(site.order().places.front(), run.place(11));
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  site.progress(r1, site.order(), msg::RoutePhase::arrived, 28);
  EXPECT_EQ(site.goal(1).state, GoalState::succeeded);
}

TEST_F(GoalRestart, RobotThatForgotItsRouteGetsItAgain) {
  for (int i = 0; i < 5; ++i) {
    site.say(site.state(r1, run.place(6)));
    site.pass(1s);
  }
  ASSERT_TRUE(site.last<msg::RouteOrder>());
  EXPECT_EQ(site.order().version, 2U);
  EXPECT_EQ(site.order().places.front(), run.place(6));
}

TEST_F(GoalRestart, ReportOnAnOldVersionChangesNothing) {
  restart_agent();
  site.pass(1s);
  site.say(site.state(r1, run.place(11)));
  ASSERT_EQ(site.order().version, 2U);
  site.progress(r1, route, msg::RoutePhase::arrived, 39);
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
}

TEST_F(GoalRestart, CancelledGoalIsEndedAfterARestartToo) {
  msg::OperatorRequest cancel = site.request(msg::OperatorRequest::Kind::goal_cancel);
  cancel.goal = goal_id(1);
  EXPECT_EQ(site.ask(cancel).outcome, msg::Outcome::done);
  site.restart();
  site.pass(2s);
  ASSERT_FALSE(site.heard<msg::RouteOrder>().empty());
  EXPECT_TRUE(site.order().ended);
  site.arrive(r1, std::nullopt);
  site.pass(2s);
  site.say(site.state(r1, run.place(5)));
  EXPECT_EQ(site.disk->occupancies.at(r1.id).held.places.front(), run.place(5));
}

TEST_F(GoalRestart, RouteOfAGoalThatIsOverIsEndedWhereverItTurnsUp) {
  site.progress(r1, route, msg::RoutePhase::arrived, 39);
  site.say(site.state(r1, run.place(39)));
  site.hush();
  site.progress(r1, route, msg::RoutePhase::driving, 3);
  ASSERT_TRUE(site.last<msg::RouteOrder>());
  EXPECT_TRUE(site.order().ended);
  EXPECT_EQ(site.order().id, route.id);
}

}  // namespace
}  // namespace weft::server::test
