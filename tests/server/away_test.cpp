#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

/// Tests a server whose process stood still: what its robots said meanwhile waits in its inbox.
namespace weft::server::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Away : testing::Test {
  void stand_still(Duration away) {
    site.now.steady += away;
    site.now.wall += away;
    site.service().was_away(away, site.now);
  }
  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r2"};
  TaughtRun run{r1, 10};
};

TEST_F(Away, NobodyIsBlamedForTheServersOwnAbsence) {
  site.arrive(r1, std::nullopt);
  site.arrive(r2, std::nullopt);
  site.pass(3s);
  stand_still(12s);
  site.say(site.state(r1, std::nullopt));
  site.pass(1s);
  EXPECT_THAT(site.events_of("robot.silent"), IsEmpty());
  site.say(site.state(r1, std::nullopt));
  site.pass(2s);  // r2 has been silent for 5 s of the time in which it could be heard
  ASSERT_THAT(site.events_of("robot.silent"), SizeIs(1));
  EXPECT_THAT(site.events_of("robot.silent").front(), HasSubstr("nothing heard of it for 5 s"));
}

TEST_F(Away, ASilentRobotStaysSilent) {
  site.arrive(r1, std::nullopt);
  site.pass(20s);
  stand_still(12s);
  site.pass(20s);
  EXPECT_THAT(site.events_of("robot.silent"), SizeIs(1));
}

TEST_F(Away, AWordFromBeforeAnOrderDoesNotMeanThatTheRobotHasForgottenIt) {
  site.arrive(r1, std::nullopt);
  site.hand_in(r1, run.next(20));
  site.label("dock", run.place(19));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "dock", "r1");
  const Route route = site.last<msg::RouteOrder>()->route;
  msg::OperatorRequest cancel = site.request(msg::OperatorRequest::Kind::goal_cancel);
  cancel.goal = goal_id(1);
  const msg::RobotState before = site.state(r1, run.place(0));
  site.ask(cancel);
  stand_still(12s);
  site.hush();
  site.say(before);  // the order was still on its way
  site.pass(2s);
  const std::vector<msg::RouteOrder> orders = site.heard<msg::RouteOrder>();
  ASSERT_FALSE(orders.empty()) << "the robot may follow it, and is told that it is over";
  EXPECT_EQ(orders.back().route.id, route.id);
  EXPECT_TRUE(orders.back().route.ended);
}

TEST_F(Away, TwinsOutliveTheServersAbsence) {
  site.arrive(r1, std::nullopt);
  Peer twin = r1;
  twin.incarnation = 2;
  for (int i = 0; i < 8; ++i) {
    site.say(site.state(r1, std::nullopt));
    site.say(site.state(twin, std::nullopt));
    site.pass(1s);
  }
  ASSERT_THAT(site.events_of("robot.twins"), SizeIs(1));
  stand_still(12s);
  site.say(site.state(twin, std::nullopt));
  site.pass(1s);
  EXPECT_THAT(site.events_of("robot.twins_ended"), IsEmpty());
}

TEST_F(Away, ANewRobotsFirstWordNamesIt) {
  site.say(site.state(r1, std::nullopt));
  EXPECT_THAT(site.events_of("robot.heard"), IsEmpty());
  site.hello(r1);
  ASSERT_THAT(site.disk->events, SizeIs(testing::Ge(1U)));
  EXPECT_EQ(site.disk->events.back().kind, "robot.heard");
  EXPECT_EQ(site.disk->events.back().who, "r1");
}

}  // namespace
}  // namespace weft::server::test
