#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// One run of 60 places, half a metre apart; r1 comes up behind r2, which has nothing to do.
struct YieldTest : testing::Test {
  YieldTest() {
    site.arrive(r1, std::nullopt);
    site.arrive(r2, std::nullopt);
    site.hand_in(r1, run.next(60));
    site.label("end", run.place(40));
    site.label("begin", run.place(12));
    site.say(site.state(r2, run.place(12)));
    site.say(site.state(r1, run.place(0)));
  }
  std::optional<Route> order_to(const Peer& robot) {
    std::optional<Route> found;
    for (const msg::RouteOrder& order : site.heard<msg::RouteOrder>()) {
      if (order.to == robot.id && !order.route.ended) found = order.route;
    }
    return found;
  }
  std::vector<Goal> yields() {
    std::vector<Goal> found;
    for (const Goal& goal : site.service().goals()) {
      if (goal.kind == GoalKind::yield) found.push_back(goal);
    }
    return found;
  }
  /// Has the robot drive to the end of what it was given, and say so.
  void arrive_at_the_end_of(Peer& robot, const Route& route) {
    site.progress(robot, route, msg::RoutePhase::arrived, route.released);
    site.say(site.state(robot, route.places[route.released]));
  }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r2"};
  TaughtRun run{r1, 10};
};

TEST_F(YieldTest, AnIdleRobotInTheWayIsAskedToMakeWay) {
  site.send_goal(1, "end", "r1");
  site.pass(3s);
  ASSERT_THAT(yields(), SizeIs(1));
  const Goal yield = yields().front();
  EXPECT_EQ(yield.robot, r2.id);
  EXPECT_EQ(yield.history.front().who, "traffic");
  EXPECT_THAT(yield.history.front().cause, HasSubstr("r2 makes way"));
  const std::optional<Route> order = order_to(r2);
  ASSERT_TRUE(order);
  EXPECT_EQ(order->goal, yield.id);
  EXPECT_EQ(order->released + 1, order->places.size()) << "all of it, at once";
  EXPECT_EQ(site.disk->occupancies.at(r2.id).held.id, order->id);
}

TEST_F(YieldTest, ItEndsByItselfAndTheOtherDrivesOn) {
  site.send_goal(1, "end", "r1");
  site.pass(3s);
  const Route first = order_to(r1).value();
  arrive_at_the_end_of(r2, order_to(r2).value());
  EXPECT_EQ(yields().front().state, GoalState::succeeded);
  site.progress(r1, first, msg::RoutePhase::driving, 1);
  site.pass(3s);
  EXPECT_GT(order_to(r1)->released, first.released);
}

TEST_F(YieldTest, WhoIsNotInTheWayIsLeftInPeace) {
  site.label("near", run.place(6));
  site.send_goal(1, "near", "r1");
  site.pass(5s);
  EXPECT_THAT(yields(), IsEmpty());
}

TEST_F(YieldTest, WhoIsStoppedIsNotAsked) {
  msg::RobotState stopped = site.state(r2, run.place(12));
  stopped.mode = msg::RobotMode::stopped;
  site.say(stopped);
  site.send_goal(1, "end", "r1");
  site.pass(5s);
  EXPECT_THAT(yields(), IsEmpty());
}

TEST_F(YieldTest, WhoHasJustComeToItsGoalIsAskedOnlyAfterAWhile) {
  site.say(site.state(r2, run.place(9)));
  site.send_goal(1, "begin", "r2");
  arrive_at_the_end_of(r2, order_to(r2).value());
  ASSERT_EQ(site.goal(1).state, GoalState::succeeded);
  site.send_goal(2, "end", "r1");
  for (int second = 0; second < 8; ++second) {
    site.say(site.state(r2, run.place(12)));
    site.say(site.state(r1, run.place(0)));
    site.pass(1s);
  }
  EXPECT_THAT(yields(), IsEmpty());
  site.say(site.state(r2, run.place(12)));
  site.say(site.state(r1, run.place(0)));
  site.pass(4s);
  EXPECT_THAT(yields(), SizeIs(1));
}

TEST_F(YieldTest, NobodyIsAskedIntoAZoneThatIsHeld) {
  msg::OperatorRequest hold = site.request(msg::OperatorRequest::Kind::rule_put);
  hold.rule = {.name = "wait", .kind = RuleKind::hold, .spans = {{run.place(10), run.place(59)}}};
  site.ask(hold);
  site.send_goal(1, "end", "r1");
  site.pass(5s);
  EXPECT_THAT(yields(), IsEmpty());
}

TEST_F(YieldTest, AGoalForWhoMakesWayComesBeforeMakingWayAgain) {
  site.send_goal(1, "end", "r1");
  site.pass(3s);
  site.label("far", run.place(59));
  site.send_goal(2, "far", "r2");
  arrive_at_the_end_of(r2, order_to(r2).value());
  site.pass(1s);
  EXPECT_EQ(site.goal(2).state, GoalState::assigned);
  EXPECT_THAT(yields(), SizeIs(1));
}

TEST_F(YieldTest, AfterARestartOfTheServerItGoesOn) {
  site.send_goal(1, "end", "r1");
  site.pass(3s);
  const Route order = order_to(r2).value();
  site.restart();
  site.arrive(r2, run.place(12));
  site.pass(1s);
  ASSERT_TRUE(order_to(r2));
  EXPECT_EQ(order_to(r2)->id, order.id);
  arrive_at_the_end_of(r2, order);
  EXPECT_EQ(yields().front().state, GoalState::succeeded);
}

TEST_F(YieldTest, ARestartedRobotThatHasLostItIsFreeAgain) {
  site.send_goal(1, "end", "r1");
  site.pass(3s);
  ASSERT_THAT(yields(), SizeIs(1));
  r2.incarnation = 2;
  site.arrive(r2, std::nullopt);
  site.say(site.state(r2, run.place(12)));
  site.pass(2s);
  EXPECT_EQ(yields().front().state, GoalState::cancelled);
}

}  // namespace
}  // namespace weft::server::test
