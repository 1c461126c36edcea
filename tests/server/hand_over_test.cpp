#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

/// Tests what becomes of goals whose robots are not heard any more.
namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Arranges two roads, 30 m of one and 10 m of the other, that lead to one dock; a robot at the beginning of each.
struct HandOver : testing::Test {
  HandOver() {
    site.arrive(r1, std::nullopt);
    site.arrive(r2, std::nullopt);
    site.hand_in(r1, near.next(21));
    Handed far_road = far.next(61);
    far_road.batch.edges.push_back(stitch(near.place(20), far.place(60)));
    site.hand_in(r2, far_road);
    site.label("dock", near.place(20));
    site.say(site.state(r1, near.place(0)));
    site.say(site.state(r2, far.place(0)));
  }
  /// Lets r1 drive a little, and fall silent.
  void r1_falls_silent(Duration silent) {
    old_route = *site.order_to(r1);
    site.progress(r1, old_route, msg::RoutePhase::driving, 2);
    only_r2_is_heard(silent);
  }
  void only_r2_is_heard(Duration silent) {
    for (Duration past{}; past < silent; past += 2s) {
      site.say(site.state(r2, far.place(0)));
      site.pass(2s);
    }
  }
  msg::OperatorReply hand_over() {
    msg::OperatorRequest request = site.request(Kind::goal_hand_over);
    request.goal = goal_id(1);
    return site.ask(request);
  }
  msg::RobotState driving() { return site.driving(r1, old_route, near.place(6)); }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r2"};
  TaughtRun near{r1, 10};
  TaughtRun far{r2, 11};
  Route old_route;
};

TEST_F(HandOver, TheGoalsHistoryTellsThatItsRobotIsNotHeardAndThatItIsAgain) {
  site.send_goal(1, "dock", "r1");
  r1_falls_silent(10s);
  EXPECT_EQ(site.goal(1).history.back().cause, "r1 is not heard; what it was released stays held");
  const std::size_t told = site.goal(1).history.size();
  only_r2_is_heard(20s);
  EXPECT_EQ(site.goal(1).history.size(), told) << "once";
  site.say(driving());
  site.pass(1s);
  EXPECT_EQ(site.goal(1).history.back().cause, "r1 is heard again");
}

TEST_F(HandOver, AnotherRobotGetsTheGoalAfterAMinute) {
  site.send_goal(1, "dock");
  ASSERT_EQ(site.goal(1).robot, r1.id) << "it has the shorter way";
  r1_falls_silent(58s);
  EXPECT_EQ(site.goal(1).robot, r1.id);
  only_r2_is_heard(6s);
  EXPECT_EQ(site.goal(1).robot, r2.id);
  ASSERT_THAT(site.events_of("goal.handed_over"), SizeIs(1));
  EXPECT_THAT(site.events_of("goal.handed_over").front(), HasSubstr("r1 has not been heard for 6"));
  ASSERT_TRUE(site.order_to(r2));
  EXPECT_NE(site.order_to(r2)->id, old_route.id) << "the route that r1 may still follow is another one";
}

TEST_F(HandOver, WhatTheSilentRobotHeldStaysHeldAndItIsToldToStandWhenItIsHeard) {
  site.send_goal(1, "dock");
  r1_falls_silent(70s);
  ASSERT_EQ(site.goal(1).robot, r2.id);
  const storage::PutOccupancy held = site.disk->occupancies.at(r1.id);
  EXPECT_EQ(held.held.id, old_route.id);
  site.hush();
  site.say(driving());
  const msg::RouteOrder order = site.last<msg::RouteOrder>().value();
  EXPECT_EQ(order.to, r1.id);
  EXPECT_TRUE(order.route.ended);
  EXPECT_EQ(order.route.id, old_route.id);
  EXPECT_EQ(site.disk->occupancies.at(r1.id).held.id, old_route.id) << "it may roll to the end of what it was given";
  site.say(site.state(r1, near.place(7)));
  site.pass(1s);
  EXPECT_NE(site.disk->occupancies.at(r1.id).held.id, old_route.id);
  EXPECT_EQ(site.disk->occupancies.at(r1.id).held.places.front(), near.place(7));
  EXPECT_EQ(site.goal(1).robot, r2.id);
}

TEST_F(HandOver, GoalForThatRobotAloneStays) {
  site.send_goal(1, "dock", "r1");
  r1_falls_silent(120s);
  EXPECT_EQ(site.goal(1).robot, r1.id);
  EXPECT_EQ(hand_over().outcome, msg::Outcome::refused);
  EXPECT_THAT(hand_over().message, HasSubstr("it was asked for r1 alone"));
}

TEST_F(HandOver, GoalOfARobotThatIsHeardIsNotTaken) {
  site.send_goal(1, "dock");
  EXPECT_EQ(hand_over().outcome, msg::Outcome::refused);
  EXPECT_THAT(hand_over().message, HasSubstr("r1 is heard"));
  EXPECT_THAT(site.events_of("goal.handed_over"), IsEmpty());
}

TEST_F(HandOver, OperatorTakesTheGoalEarlier) {
  site.send_goal(1, "dock");
  r1_falls_silent(10s);
  const msg::OperatorReply reply = hand_over();
  EXPECT_EQ(reply.outcome, msg::Outcome::done) << reply.message;
  site.say(site.state(r2, far.place(0)));
  site.pass(1s);
  EXPECT_EQ(site.goal(1).robot, r2.id);
}

TEST_F(HandOver, HandedOverGoalOutlivesTheServer) {
  site.send_goal(1, "dock");
  r1_falls_silent(70s);
  ASSERT_EQ(site.goal(1).robot, r2.id);
  site.restart();
  site.arrive(r2, far.place(0));
  site.pass(1s);
  EXPECT_EQ(site.goal(1).robot, r2.id);
  site.hush();
  site.arrive(r1, std::nullopt);
  site.say(driving());
  const msg::RouteOrder order = site.last<msg::RouteOrder>().value();
  EXPECT_EQ(order.to, r1.id);
  EXPECT_TRUE(order.route.ended);
}

}  // namespace
}  // namespace weft::server::test
