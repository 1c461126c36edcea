#include "agents/methods/topometric/plan.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace weft::agents {
namespace {

const PlanConfig kConfig;
const SensorTime kNow{from_seconds(100.0)};

PlanState in(PlanMode mode) {
  return {mode, std::nullopt, false};
}
SensorTime after(double s) {
  return kNow + from_seconds(s);
}

// Each test is an arrow of figure 5, and named by it.

TEST(PlanArrows, GlobalPlanToLocalPlanWithALocalGoal) {
  const Planned next = plan_next(kConfig, PlanState{}, PlanEvent::has_local_goal, kNow);
  EXPECT_EQ(next.state.mode, PlanMode::execute_local_plan);
  EXPECT_EQ(next.effect, PlanEffect::drive);
}

TEST(PlanArrows, LocalPlanStaysWhileThereIsALocalGoal) {
  const Planned next = plan_next(kConfig, in(PlanMode::execute_local_plan), PlanEvent::has_local_goal, kNow);
  EXPECT_EQ(next.state.mode, PlanMode::execute_local_plan);
  EXPECT_EQ(next.effect, PlanEffect::drive);
}

TEST(PlanArrows, LocalPlanToSwitchPendingWhereTheChartEnds) {
  const Planned next = plan_next(kConfig, in(PlanMode::execute_local_plan), PlanEvent::chart_ends, kNow);
  EXPECT_EQ(next.state.mode, PlanMode::switch_pending);
  EXPECT_EQ(next.effect, PlanEffect::drive_slowly);
}

TEST(PlanArrows, SwitchPendingToLocalPlanOnceTheNextChartIsMade) {
  const Planned next = plan_next(kConfig, in(PlanMode::switch_pending), PlanEvent::has_local_goal, kNow);
  EXPECT_EQ(next.state.mode, PlanMode::execute_local_plan);
  EXPECT_EQ(next.effect, PlanEffect::drive);
}

TEST(PlanArrows, LocalPlanToGlobalPlanOnArrival) {
  const Planned next = plan_next(kConfig, in(PlanMode::execute_local_plan), PlanEvent::arrived, kNow);
  EXPECT_EQ(next.state.mode, PlanMode::generate_global_plan);
  EXPECT_EQ(next.effect, PlanEffect::plan_globally);
}

TEST(PlanArrows, AnyStateToLostWhenTheRobotDoesNotKnowWhereItIs) {
  for (const PlanMode mode :
       {PlanMode::generate_global_plan, PlanMode::execute_local_plan, PlanMode::switch_pending}) {
    const Planned next = plan_next(kConfig, in(mode), PlanEvent::is_lost, kNow);
    EXPECT_EQ(next.state.mode, PlanMode::lost);
    EXPECT_EQ(next.effect, PlanEffect::clear_costmap);
  }
}

TEST(PlanArrows, LocalPlanToLostWithoutAWayForFiveSeconds) {
  Planned next = plan_next(kConfig, in(PlanMode::execute_local_plan), PlanEvent::has_no_way, kNow);
  EXPECT_EQ(next.state.mode, PlanMode::execute_local_plan);
  EXPECT_EQ(next.effect, PlanEffect::stand);
  next = plan_next(kConfig, next.state, PlanEvent::has_no_way, after(4.9));
  EXPECT_EQ(next.state.mode, PlanMode::execute_local_plan);
  next = plan_next(kConfig, next.state, PlanEvent::has_no_way, after(5.0));
  EXPECT_EQ(next.state.mode, PlanMode::lost);
  EXPECT_EQ(next.effect, PlanEffect::clear_costmap);
}

TEST(PlanArrows, AWayBetweenTwoWithoutBeginsTheFiveSecondsAnew) {
  Planned next = plan_next(kConfig, in(PlanMode::execute_local_plan), PlanEvent::has_no_way, kNow);
  next = plan_next(kConfig, next.state, PlanEvent::has_local_goal, after(4.0));
  next = plan_next(kConfig, next.state, PlanEvent::has_no_way, after(6.0));
  EXPECT_EQ(next.state.mode, PlanMode::execute_local_plan);
}

TEST(PlanArrows, LostLooksAroundTwiceAndThenStands) {
  Planned next = plan_next(kConfig, in(PlanMode::execute_local_plan), PlanEvent::is_lost, kNow);
  const double whole_rad = 2.0 * std::numbers::pi;
  next = plan_next(kConfig, next.state, PlanEvent::is_lost, after(1.0), 0.1);
  EXPECT_EQ(next.effect, PlanEffect::look_around);
  next = plan_next(kConfig, next.state, PlanEvent::is_lost, after(20.0), 2.0 * whole_rad - 0.01);
  EXPECT_EQ(next.effect, PlanEffect::look_around);
  next = plan_next(kConfig, next.state, PlanEvent::is_lost, after(21.0), 2.0 * whole_rad);
  EXPECT_EQ(next.state.mode, PlanMode::lost);
  EXPECT_EQ(next.effect, PlanEffect::stand);
}

TEST(PlanArrows, LostToGlobalPlanWhenFound) {
  const Planned next = plan_next(kConfig, in(PlanMode::lost), PlanEvent::is_found, kNow);
  EXPECT_EQ(next.state.mode, PlanMode::generate_global_plan);
  EXPECT_EQ(next.effect, PlanEffect::plan_globally);
}

TEST(PlanArrows, LostToGlobalPlanWhenAWayLeadsOnAgain) {
  for (const PlanEvent event : {PlanEvent::has_local_goal, PlanEvent::chart_ends}) {
    const Planned next = plan_next(kConfig, in(PlanMode::lost), event, kNow);
    EXPECT_EQ(next.state.mode, PlanMode::generate_global_plan);
    EXPECT_EQ(next.effect, PlanEffect::plan_globally);
  }
}

TEST(Plan, StandsBeforeWhatIsInTheWayAndForgetsItOnce) {
  Planned next = plan_next(kConfig, in(PlanMode::execute_local_plan), PlanEvent::is_blocked, kNow);
  EXPECT_EQ(next.state.mode, PlanMode::execute_local_plan);
  EXPECT_EQ(next.effect, PlanEffect::stand);
  next = plan_next(kConfig, next.state, PlanEvent::is_blocked, after(5.0));
  EXPECT_EQ(next.effect, PlanEffect::clear_costmap);
  for (const double s : {6.0, 12.0, 60.0}) {
    next = plan_next(kConfig, next.state, PlanEvent::is_blocked, after(s));
    EXPECT_EQ(next.state.mode, PlanMode::execute_local_plan);
    EXPECT_EQ(next.effect, PlanEffect::stand);
  }
}

TEST(Plan, ClearsTheCostmapOnceEachTimeItIsLost) {
  Planned next = plan_next(kConfig, PlanState{}, PlanEvent::is_lost, kNow);
  EXPECT_EQ(next.effect, PlanEffect::clear_costmap);
  next = plan_next(kConfig, next.state, PlanEvent::is_lost, after(1.0));
  EXPECT_NE(next.effect, PlanEffect::clear_costmap);
  next = plan_next(kConfig, next.state, PlanEvent::is_found, after(2.0));
  next = plan_next(kConfig, next.state, PlanEvent::is_lost, after(3.0));
  EXPECT_EQ(next.effect, PlanEffect::clear_costmap);
}

}  // namespace
}  // namespace weft::agents
