#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/blocked_on_run.hpp"

/// Tests what becomes of the goal of a robot that stays blocked.
namespace weft::server::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

struct BlockedTest : BlockedOnRun {
  Route start() {
    site.say(site.state(r1, run.place(0)));
    site.send_goal(1, "dock", "r1");
    site.pass(1s);
    return site.order();
  }
};

TEST_F(BlockedTest, ARobotThatStaysBlockedIsLedRoundThatAndKeepsItsGoal) {
  const Route route = start();
  ASSERT_THAT(route.places, Contains(run.place(12)));
  stand_blocked(route, 10, 29s);
  EXPECT_FALSE(site.order().ended);
  stand_blocked(route, 10, 3s);
  EXPECT_EQ(site.order().id, route.id);
  obey(run.place(10));
  const Route round = *site.order_to(r1);
  EXPECT_NE(round.id, route.id);
  EXPECT_THAT(round.places, Contains(bypass.place(2)));
  EXPECT_THAT(round.places, Not(Contains(run.place(12))));
  EXPECT_EQ(round.places.back(), run.place(39));
  EXPECT_EQ(round.released + 1, round.places.size()) << "the plan leads it round, too";
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  EXPECT_THAT(site.why(1), AllOf(HasSubstr("planned anew for r1"), HasSubstr("r1 found the way blocked between"),
                                 HasSubstr("closed for this goal until")));
  EXPECT_THAT(site.events_of("goal.blocked"), SizeIs(1));
}

TEST_F(BlockedTest, ARobotThatGivesUpAsSomethingIsInItsWayIsLedRoundThat) {
  const Route route = start();
  give_up(route, 10);
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  obey(run.place(10));
  EXPECT_THAT(site.order_to(r1)->places, Contains(bypass.place(2)));
}

TEST_F(BlockedTest, WithNoOtherWayItWaitsSaysSoAndTriesAgainTenMinutesLater) {
  const Route route = start();
  give_up(route, 25);
  obey(run.place(25), 5);
  EXPECT_EQ(site.order_to(r1)->id, route.id) << "no other route yet";
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  EXPECT_THAT(site.why(1), AllOf(HasSubstr("r1 found the way blocked between " + to_string(run.place(26)) + " and " +
                                           to_string(run.place(28))),
                                 HasSubstr("no other way leads there: it waits")));
  const msg::RobotWait wait = site.row("r1").wait;
  EXPECT_EQ(wait.at, run.place(25));
  EXPECT_EQ(wait.needs, run.place(28));
  site.stand(r1, run.place(25), 585);
  EXPECT_EQ(site.order_to(r1)->id, route.id);
  site.stand(r1, run.place(25), 20);
  EXPECT_NE(site.order_to(r1)->id, route.id);
  EXPECT_THAT(site.order_to(r1)->places, Contains(run.place(27)));
  EXPECT_THAT(site.events_of("goal.goes_on"), Contains(HasSubstr("it has been closed for long enough")));
}

TEST_F(BlockedTest, ItTriesAgainOnceAnotherRobotHasDrivenThere) {
  const Route route = start();
  give_up(route, 25);
  obey(run.place(25), 3);
  // A hand takes r1 aside, and r2 comes by.
  site.stand(r1, bypass.place(3), 2);
  Peer r2{.id = robot_id(2), .name = "r2"};
  site.arrive(r2, run.place(22));
  site.send_goal(2, "dock", "r2");
  site.pass(1s);
  const Route others = *site.order_to(r2);
  ASSERT_THAT(others.places, Contains(run.place(27))) << "it is closed for the other goal alone";
  site.progress(r2, others, msg::RoutePhase::driving, 3, 4);
  site.stand(r1, bypass.place(3), 1);
  EXPECT_THAT(site.events_of("goal.goes_on"), IsEmpty());
  site.progress(r2, others, msg::RoutePhase::driving, 6, 8);
  EXPECT_THAT(site.events_of("goal.goes_on"), Contains(HasSubstr("r2 has driven it")));
  site.stand(r1, bypass.place(3), 2);
  EXPECT_THAT(site.order_to(r1)->places, Contains(run.place(27)));
}

TEST_F(BlockedTest, WhatIsFoundNextIsClosedBesidesWhatWasFoundBefore) {
  give_up(start(), 10);
  obey(run.place(10));
  const Route round = *site.order_to(r1);
  const auto at = static_cast<std::uint32_t>(std::find(round.places.begin(), round.places.end(), bypass.place(2)) -
                                             round.places.begin());
  give_up(round, at);
  obey(bypass.place(2), 3);
  EXPECT_EQ(site.order_to(r1)->id, round.id) << "no way is left";
  EXPECT_THAT(site.why(1), HasSubstr("; r1 found the way blocked between"));
}

TEST_F(BlockedTest, ACancelledGoalLeavesNothingClosed) {
  give_up(start(), 25);
  obey(run.place(25));
  msg::OperatorRequest cancel = site.request(msg::OperatorRequest::Kind::goal_cancel);
  cancel.goal = goal_id(1);
  site.ask(cancel);
  site.stand(r1, run.place(25), 3);
  site.send_goal(2, "dock", "r1");
  site.pass(1s);
  EXPECT_THAT(site.order_to(r1)->places, Contains(run.place(27)));
}

TEST_F(BlockedTest, AfterARestartOfTheServerItIsTriedOnceMore) {
  const Route route = start();
  give_up(route, 25);
  obey(run.place(25), 3);
  site.restart();
  site.arrive(r1, run.place(25));
  site.stand(r1, run.place(25), 15);
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  EXPECT_THAT(site.order_to(r1)->places, Contains(run.place(27)));
}

}  // namespace
}  // namespace weft::server::test
