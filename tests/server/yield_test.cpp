#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/server/one_run.hpp"

namespace weft::server::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Arranges r1 behind r2, which has nothing to do.
struct YieldTest : OneRun {
  YieldTest() {
    site.arrive(r2, std::nullopt);
    site.label("end", run.place(40));
    site.label("begin", run.place(12));
    site.say(site.state(r2, run.place(12)));
    site.say(site.state(r1, run.place(0)));
  }
  std::vector<Goal> yields() { return site.goals_of(GoalKind::yield); }
  /// Has the robot drive to the end of what it was given, and say so.
  void arrive_at_the_end_of(Peer& robot, const Route& route) {
    site.progress(robot, route, msg::RoutePhase::arrived, route.released);
    site.say(site.state(robot, route.places[route.released]));
  }
};

TEST_F(YieldTest, AnIdleRobotInTheWayIsAskedToMakeWay) {
  site.send_goal(1, "end", "r1");
  site.pass(3s);
  ASSERT_THAT(yields(), SizeIs(1));
  const Goal yield = yields().front();
  EXPECT_EQ(yield.robot, r2.id);
  EXPECT_EQ(yield.history.front().who, "traffic");
  EXPECT_THAT(yield.history.front().cause, HasSubstr("r2 makes way"));
  const std::optional<Route> order = site.order_to(r2);
  ASSERT_TRUE(order);
  EXPECT_EQ(order->goal, yield.id);
  EXPECT_EQ(order->released + 1, order->places.size()) << "all of it, at once";
  EXPECT_EQ(site.disk->occupancies.at(r2.id).held.id, order->id);
}

/// Arranges r3, which dies ahead of both.
struct DeadAheadTest : YieldTest {
  Peer r3{.id = robot_id(3), .name = "r3"};

  void die(const PlaceId& at) {
    site.arrive(r3, std::nullopt);
    site.say(site.state(r3, at));
    for (int second = 0; second < 30; ++second) {
      site.say(site.state(r2, run.place(25)));
      site.stand(r1, run.place(10), 1);
    }
    ASSERT_FALSE(site.row("r3").is_heard);
  }
  /// Sends r1 to the end: r2 makes way until there is no room left before r3.
  void drive_up() {
    site.send_goal(1, "end", "r1");
    PlaceId behind_it = run.place(25);
    for (int pieces = 0; pieces < 4; ++pieces) {
      const Route route = site.order_to(r1).value();
      site.progress(r1, route, msg::RoutePhase::waiting, route.released);
      if (const std::optional<Route> aside = site.order_to(r2)) {
        arrive_at_the_end_of(r2, *aside);
        behind_it = aside->places.back();
      }
      site.stand(r2, behind_it, 3);
    }
  }
};

TEST_F(DeadAheadTest, WhoIsCutOffWaitsForItAndNotForWhoStandsBetween) {
  die(run.place(30));
  drive_up();
  EXPECT_THAT(site.row("r1").wait.held_by, ElementsAre(r3.id));
}

TEST_F(DeadAheadTest, WhoIsCutOffByOneOnTheOtherWayAlongTheAisleWaitsForItToo) {
  TaughtRun back(r2, 11);
  Handed other_way = back.next(10);
  other_way.batch.edges.push_back(turned(stitch(run.place(33), back.place(0), 0.1), std::numbers::pi));
  site.hand_in(r2, other_way);
  die(back.place(6));
  drive_up();
  EXPECT_THAT(site.row("r1").wait.held_by, ElementsAre(r3.id));
}

TEST_F(YieldTest, ItEndsByItselfAndTheOtherDrivesOn) {
  site.send_goal(1, "end", "r1");
  site.pass(3s);
  const Route first = site.order_to(r1).value();
  arrive_at_the_end_of(r2, site.order_to(r2).value());
  EXPECT_EQ(yields().front().state, GoalState::succeeded);
  site.progress(r1, first, msg::RoutePhase::driving, 1);
  site.pass(3s);
  EXPECT_GT(site.order_to(r1)->released, first.released);
}

TEST_F(YieldTest, WhoIsNotInTheWayIsLeftInPeace) {
  site.label("near", run.place(6));
  site.send_goal(1, "near", "r1");
  site.pass(5s);
  EXPECT_THAT(yields(), IsEmpty());
}

TEST_F(YieldTest, WhoIsStoppedIsNotAsked) {
  site.stand_stopped(r2, run.place(12));
  site.send_goal(1, "end", "r1");
  site.pass(5s);
  EXPECT_THAT(yields(), IsEmpty());
}

TEST_F(YieldTest, WhoHasJustComeToItsGoalIsAskedOnlyAfterAWhile) {
  site.say(site.state(r2, run.place(9)));
  site.send_goal(1, "begin", "r2");
  arrive_at_the_end_of(r2, site.order_to(r2).value());
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
  site.put_rule({.name = "wait", .kind = RuleKind::hold, .spans = {{run.place(10), run.place(59)}}});
  site.send_goal(1, "end", "r1");
  site.pass(5s);
  EXPECT_THAT(yields(), IsEmpty());
}

TEST_F(YieldTest, AGoalForWhoMakesWayComesBeforeMakingWayAgain) {
  site.send_goal(1, "end", "r1");
  site.pass(3s);
  site.label("far", run.place(59));
  site.send_goal(2, "far", "r2");
  arrive_at_the_end_of(r2, site.order_to(r2).value());
  site.pass(1s);
  EXPECT_EQ(site.goal(2).state, GoalState::assigned);
  EXPECT_THAT(yields(), SizeIs(1));
}

TEST_F(YieldTest, AfterARestartOfTheServerItGoesOn) {
  site.send_goal(1, "end", "r1");
  site.pass(3s);
  const Route order = site.order_to(r2).value();
  site.restart();
  site.arrive(r2, run.place(12));
  site.pass(1s);
  ASSERT_TRUE(site.order_to(r2));
  EXPECT_EQ(site.order_to(r2)->id, order.id);
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
