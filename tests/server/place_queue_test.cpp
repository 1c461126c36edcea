#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/one_run.hpp"

/// Tests that a second robot does not set off to where another one goes, or works.
namespace weft::server::test {
namespace {

/// Arranges two robots, r2 behind r1, that are both to go to the dock.
struct PlaceQueue : OneRun {
  PlaceQueue() {
    site.arrive(r2, std::nullopt);
    site.label("dock", run.place(40));
    site.label("far", run.place(55));
    site.say(site.state(r1, run.place(20)));
    site.say(site.state(r2, run.place(0)));
  }
  void arrive_with_r1() {
    const Route route = site.order_to(r1).value();
    site.progress(r1, route, msg::RoutePhase::arrived, route.released);
    site.say(site.state(r1, run.place(40)));
  }
  GoalState state(std::uint8_t goal) { return site.goal(goal).state; }
};

TEST_F(PlaceQueue, TheNextGoalForThePlaceWaitsAndSaysForWhom) {
  site.send_goal(1, "dock", "r1");
  ASSERT_EQ(state(1), GoalState::assigned);
  site.send_goal(2, "dock", "r2");
  site.stand(r2, run.place(0), 2);
  EXPECT_EQ(state(2), GoalState::pending);
  EXPECT_EQ(site.why(2), "r1 is at dock or on its way there; it comes next");
}

TEST_F(PlaceQueue, ItIsGivenOutOnceTheFirstOneHasDoneItsWork) {
  site.send_goal(1, "dock", "r1");
  site.send_goal(2, "dock", "r2");
  arrive_with_r1();
  site.stand(r2, run.place(0), 5);
  EXPECT_EQ(state(2), GoalState::pending) << "r1 is at work";
  site.stand(r2, run.place(0), 8);
  EXPECT_EQ(state(2), GoalState::assigned) << "r1 only stands there: it makes way";
}

TEST_F(PlaceQueue, AGoalForAnyRobotChoosesNoSecondOne) {
  site.send_goal(1, "dock", "r1");
  site.send_goal(2, "dock");
  site.stand(r2, run.place(0), 2);
  EXPECT_EQ(state(2), GoalState::pending);
  arrive_with_r1();
  site.stand(r1, run.place(40), 2);
  EXPECT_EQ(site.goal(2).robot, r1.id) << "it is there, and ready";
}

TEST_F(PlaceQueue, GoalsForOtherPlacesDoNotWait) {
  site.send_goal(1, "dock", "r1");
  site.send_goal(2, "dock", "r2");
  site.send_goal(3, "far", "r2");
  site.stand(r2, run.place(0), 2);
  EXPECT_EQ(state(3), GoalState::assigned);
}

TEST_F(PlaceQueue, NobodyWaitsForARobotThatDoesNotMoveByItself) {
  site.send_goal(1, "dock", "r1");
  site.progress(r1, site.order_to(r1).value(), msg::RoutePhase::driving);
  msg::OperatorRequest stop = site.request(msg::OperatorRequest::Kind::stop);
  stop.robot = "r1";
  site.say(stop);
  ASSERT_EQ(state(1), GoalState::paused);
  site.send_goal(2, "dock", "r2");
  site.stand(r2, run.place(0), 2);
  EXPECT_EQ(state(2), GoalState::assigned);
}

TEST_F(PlaceQueue, WhoIsThereDoesNotOvertakeWhoWaits) {
  site.send_goal(1, "dock", "r1");
  site.send_goal(2, "dock", "r2");
  site.send_goal(3, "dock", "r1");
  arrive_with_r1();
  for (int second = 0; second < 13; ++second) {
    site.say(site.state(r1, run.place(40)));
    site.stand(r2, run.place(0), 1);
    if (second < 8) {
      EXPECT_EQ(state(3), GoalState::pending) << second;
    }
  }
  EXPECT_EQ(state(2), GoalState::assigned);
  EXPECT_EQ(state(3), GoalState::pending);
}

}  // namespace
}  // namespace weft::server::test
