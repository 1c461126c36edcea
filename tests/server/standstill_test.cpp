#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Arranges one aisle of 60 places, half a metre apart, taught in both directions: place k of the way back lies on
/// place 40 - k of the way there.
struct StandstillTest : testing::Test {
  StandstillTest() {
    for (Peer* robot : {&r1, &r2, &r3}) site.arrive(*robot, std::nullopt);
    site.hand_in(r1, there.next(60));
    Handed way_back = back.next(60);
    way_back.batch.edges.push_back(turned(stitch(there.place(40), back.place(0)), std::numbers::pi));
    site.hand_in(r2, way_back);
    site.label("end", there.place(59));
    site.label("begin", back.place(40));
  }
  Route order_to(const Peer& robot) { return site.order_to(robot).value(); }
  msg::RobotRow row(const Peer& robot) { return site.row(robot.name); }
  /// Lets two robots meet head-on: both in the aisle already, each has driven as far as it was let.
  void meet_head_on() {
    site.say(site.state(r2, back.place(3)));
    site.say(site.state(r1, there.place(0)));
    site.send_goal(1, "end", "r1");
    site.send_goal(2, "begin", "r2");
    for (Peer* robot : {&r1, &r2}) {
      const Route order = order_to(*robot);
      site.progress(*robot, order, msg::RoutePhase::waiting, order.released);
    }
  }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r2"};
  Peer r3{.id = robot_id(3), .name = "r3"};
  TaughtRun there{r1, 10};
  TaughtRun back{r2, 11};
};

TEST_F(StandstillTest, RobotThatIsAskedToDriveAndDoesNotMoveIsNamedAfterHalfAMinute) {
  site.say(site.state(r1, there.place(10)));
  site.say(site.state(r2, there.place(0)));
  site.send_goal(1, "end", "r1");
  const Route order = order_to(r1);
  site.label("before", there.place(50));
  site.send_goal(2, "before", "r2");
  const auto blocked_for = [&](Duration time) {
    for (Duration past{}; past < time; past += 1s) {
      msg::RobotState state = site.state(r1, there.place(10));
      state.mode = msg::RobotMode::driving;
      state.goal = order.goal;
      state.route = order.id;
      state.route_version = order.version;
      state.safety = Safety::blocked;
      site.say(state);
      site.progress(r1, order, msg::RoutePhase::driving, 0);
      if (const auto mine = site.last<msg::RouteOrder>(); mine && mine->to == r2.id) {
        site.progress(r2, mine->route, msg::RoutePhase::waiting, mine->route.released);
      }
      site.say(site.state(r2, there.place(0)));
      site.pass(1s);
    }
  };
  blocked_for(28s);
  EXPECT_THAT(site.events_of("robot.blocked"), IsEmpty());
  blocked_for(6s);
  ASSERT_THAT(site.events_of("robot.blocked"), SizeIs(1));
  ASSERT_THAT(site.events_of("traffic.standstill"), SizeIs(1));
  EXPECT_THAT(site.events_of("traffic.standstill").front(),
              AllOf(HasSubstr("r1 is asked to drive and does not move"), HasSubstr("in the way of r2")));
}

TEST_F(StandstillTest, TwoThatMeetHeadOnAreNamedWithinTwoSeconds) {
  meet_head_on();
  EXPECT_THAT(site.events_of("traffic.standstill"), IsEmpty());
  site.pass(2s);
  ASSERT_THAT(site.events_of("traffic.standstill"), SizeIs(1));
  EXPECT_THAT(site.events_of("traffic.standstill").front(),
              AllOf(HasSubstr("r1 and r2 wait for one another (2 robots)"), HasSubstr("weft goal cancel ID")));
}

TEST_F(StandstillTest, RobotsSayForWhomTheyWaitAndInWhichStandstill) {
  meet_head_on();
  site.pass(2s);
  const msg::RobotRow first = row(r1);
  EXPECT_EQ(first.wait.at, there.place(order_to(r1).released));
  EXPECT_THAT(first.wait.held_by, ElementsAre(r2.id));
  EXPECT_TRUE(first.wait.needs);
  EXPECT_EQ(seconds(site.now.wall - first.wait.since), 2.0);
  EXPECT_THAT(row(r2).wait.held_by, ElementsAre(r1.id));
  EXPECT_THAT(first.standstill, HasSubstr("wait for one another"));
  EXPECT_EQ(row(r2).standstill, first.standstill);
  EXPECT_FALSE(row(r3).wait.at);
  EXPECT_THAT(row(r3).standstill, IsEmpty());
}

TEST_F(StandstillTest, OnesThatStillDriveToWhereTheyAreLetAreNone) {
  meet_head_on();
  site.progress(r1, order_to(r1), msg::RoutePhase::driving, 2);
  site.pass(4s);
  EXPECT_THAT(site.events_of("traffic.standstill"), IsEmpty());
  EXPECT_FALSE(row(r1).wait.at);
}

TEST_F(StandstillTest, ItIsToldWhenItIsOver) {
  meet_head_on();
  site.pass(2s);
  EXPECT_THAT(site.events_of("traffic.standstill_over"), IsEmpty());
  msg::OperatorRequest cancel = site.request(Kind::goal_cancel);
  cancel.goal = goal_id(2);
  site.ask(cancel);
  site.pass(1s);
  EXPECT_THAT(site.events_of("traffic.standstill_over"), SizeIs(1));
}

TEST_F(StandstillTest, ItIsToldAgainEachTenMinutes) {
  meet_head_on();
  for (int second = 0; second < 605; ++second) {
    site.pass(1s);
    for (Peer* robot : {&r1, &r2}) {
      msg::RobotState state = site.state(*robot, order_to(*robot).places[order_to(*robot).released]);
      state.route = order_to(*robot).id;
      state.route_version = 1;
      state.mode = msg::RobotMode::waiting;
      site.say(state);
    }
  }
  EXPECT_THAT(site.events_of("traffic.standstill"), SizeIs(2));
}

TEST_F(StandstillTest, IdleRobotOnTheWayIsNamed) {
  // From the end of the aisle nothing leads on: it cannot be asked to make way.
  site.say(site.state(r3, there.place(59)));
  site.say(site.state(r1, there.place(10)));
  site.send_goal(1, "end", "r1");
  site.progress(r1, order_to(r1), msg::RoutePhase::waiting, order_to(r1).released);
  site.pass(2s);
  ASSERT_THAT(site.events_of("traffic.standstill"), SizeIs(1));
  EXPECT_THAT(site.events_of("traffic.standstill").front(),
              AllOf(HasSubstr("r3 is idle and in the way of r1"), HasSubstr("weft goal send --to LABEL --robot r3")));
  EXPECT_THAT(row(r1).standstill, HasSubstr("r3 is idle"));
}

TEST_F(StandstillTest, SilentRobotInTheWayIsNamed) {
  site.say(site.state(r3, there.place(30)));
  site.pass(20s);
  site.say(site.state(r1, there.place(10)));
  site.send_goal(1, "end", "r1");
  site.progress(r1, order_to(r1), msg::RoutePhase::waiting, order_to(r1).released);
  site.pass(2s);
  ASSERT_THAT(site.events_of("traffic.standstill"), SizeIs(1));
  EXPECT_THAT(site.events_of("traffic.standstill").front(),
              AllOf(HasSubstr("r3 is not heard and in the way of r1"), HasSubstr("weft robot clear r3")));
}

TEST_F(StandstillTest, AllThatAreInTheWayAreNamed) {
  TaughtRun again(r3, 12);
  Handed way_back = again.next(60);
  way_back.batch.edges.push_back(turned(stitch(there.place(40), again.place(0)), std::numbers::pi));
  site.hand_in(r3, way_back);
  site.say(site.state(r2, back.place(9)));
  site.say(site.state(r3, again.place(9)));
  site.say(site.state(r1, there.place(10)));
  site.send_goal(1, "end", "r1");
  EXPECT_THAT(site.goal(1).history.back().cause, HasSubstr("r1 waits until r2 and r3 have left its way"));
  site.progress(r1, order_to(r1), msg::RoutePhase::waiting, order_to(r1).released);
  site.pass(2s);
  EXPECT_THAT(row(r1).wait.held_by, ElementsAre(r2.id, r3.id));
  EXPECT_THAT(site.events_of("traffic.standstill"), SizeIs(2));
}

}  // namespace
}  // namespace weft::server::test
