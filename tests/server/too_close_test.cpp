#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/traffic_site.hpp"

/// Tests how robots part that stand too close to each other, or within what another one holds.
namespace weft::server::test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

TEST_F(TrafficTest, RobotThatStandsTooCloseIsNotSentOffTowardsTheOther) {
  site.say(site.state(r1, run.place(11)));
  site.say(site.state(r2, run.place(10)));
  EXPECT_THAT(site.events_of("traffic.too_close"), SizeIs(1));
  site.send_goal(1, "end", "r2");
  EXPECT_FALSE(site.order_to(r2));
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
  expect_apart();
  site.say(site.state(r1, run.place(4)));
  site.say(site.state(r2, run.place(10)));
  site.pass(1s);
  ASSERT_TRUE(site.order_to(r2));
  EXPECT_EQ(site.order_to(r2)->released, 49U);
  expect_apart();
}

TEST_F(TrafficTest, RobotThatStandsTooCloseMayMoveAway) {
  site.say(site.state(r1, run.place(10)));
  site.say(site.state(r2, run.place(11)));
  ASSERT_THAT(site.events_of("traffic.too_close"), SizeIs(1));
  site.send_goal(1, "end", "r2");
  site.pass(1s);
  ASSERT_TRUE(site.order_to(r2));
  EXPECT_EQ(site.order_to(r2)->released, 48U) << "a piece, and from there nobody is in the way";
}

TEST_F(TrafficTest, RobotBesideItsPlaceDoesNotMoveAwayByWayOfIt) {
  site.say(site.state(r1, run.place(10)));
  msg::RobotState beside = site.state(r2, run.place(11));
  Metric2 off;
  off.a_from_b.y = 1.4;
  beside.place_from_robot = off;
  site.say(beside);
  ASSERT_THAT(site.events_of("traffic.too_close"), SizeIs(1));
  site.send_goal(1, "end", "r2");
  site.pass(1s);
  EXPECT_FALSE(site.order_to(r2)) << "it would drive to its place first, which is nearer to the other robot";
}

TEST_F(TrafficTest, RobotWithinAnotherOnesWayDoesNotMoveAlongIt) {
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  site.say(site.state(r2, run.place(20)));
  ASSERT_THAT(site.events_of("traffic.too_close"), SizeIs(1));
  site.label("before-end", run.place(57));
  site.send_goal(2, "before-end", "r2");
  EXPECT_FALSE(site.order_to(r2));
  EXPECT_THAT(site.goal(2).history.back().cause, HasSubstr("r2 waits until r1 has left its way"));
}

/// Arranges a lane that leaves the run, on which r2 stands within what r1 was given.
struct LeavingLane : TrafficTest {
  /// Gives r2 a goal at the lane's end; the lane is turned so far from the run, in radians.
  void send_out_of_r1s_way(double turn) {
    Handed lane = aside.next(60);
    lane.batch.edges.push_back(turned(stitch(run.place(10), aside.place(0)), turn));
    site.hand_in(r2, lane);
    site.label("aside", aside.place(59));
    site.say(site.state(r1, run.place(0)));
    site.send_goal(1, "end", "r1");
    ASSERT_TRUE(site.order_to(r1));
    site.say(site.state(r2, aside.place(2)));
    site.send_goal(2, "aside", "r2");
  }
  TaughtRun aside{r2, 11};
};

TEST_F(LeavingLane, RobotDoesNotMoveAlongTheOtherOnesWayOnOneThatHardlyLeavesIt) {
  send_out_of_r1s_way(0.15);
  site.pass(1s);
  EXPECT_FALSE(site.order_to(r2));
}

TEST_F(LeavingLane, RobotMovesAwayNoFartherThanAPieceWithinWhatAnotherOneHolds) {
  send_out_of_r1s_way(0.5);
  ASSERT_TRUE(site.order_to(r2));
  EXPECT_EQ(site.order_to(r2)->released, 3U);
  site.pass(1s);
  EXPECT_EQ(site.order_to(r2)->released, 3U) << "it has not driven that yet";
  site.progress(r2, *site.order_to(r2), msg::RoutePhase::waiting, 2);
  site.pass(1s);
  EXPECT_GE(site.order_to(r2)->released, 20U) << "another piece, and it is clear of the other lane";
}

TEST_F(TrafficTest, RobotThatStandsTooCloseIsInTheWayAfterARestartToo) {
  site.say(site.state(r1, run.place(10)));
  site.say(site.state(r2, run.place(11)));
  ASSERT_THAT(site.events_of("traffic.too_close"), SizeIs(1));
  site.restart();
  site.arrive(r1, run.place(10));
  site.send_goal(1, "end", "r1");
  EXPECT_FALSE(site.order_to(r1)) << "r2 has not been heard, and stands where it stood";
  site.arrive(r2, run.place(11));
  site.pass(1s);
  EXPECT_FALSE(site.order_to(r1));
}

TEST_F(TrafficTest, RobotMovedBeforeItSetOffIsPlannedAnew) {
  site.say(site.state(r1, run.place(11)));
  site.say(site.state(r2, run.place(10)));
  site.send_goal(1, "end", "r2");
  EXPECT_FALSE(site.order_to(r2));
  r2.incarnation = 2;
  site.arrive(r2, std::nullopt);
  site.say(site.state(r2, run.place(25)));
  site.pass(2s);
  ASSERT_TRUE(site.order_to(r2));
  EXPECT_EQ(site.order_to(r2)->places.front(), run.place(25));
  EXPECT_EQ(site.order_to(r2)->released, 34U);
  expect_apart();
}

}  // namespace
}  // namespace weft::server::test
