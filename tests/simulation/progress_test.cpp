#include "tests/simulation/progress.hpp"

#include <gtest/gtest.h>

namespace weft::simulation {
namespace {

constexpr SteadyTime kBegin(std::chrono::hours(1));

GoalSight goal(double free_s) {
  GoalId id;
  id.bytes[0] = 1;
  return {id, GoalKind::operator_asked, free_s, true};
}

std::vector<Progress::Late> after(Progress& progress, double seconds, const GoalSight& goal) {
  return progress.look(kBegin + from_seconds(seconds), {goal});
}

TEST(ProgressOfGoals, OneMayTakeTenTimesItsDrivingAndAQuarterOfAnHour) {
  Progress progress;
  after(progress, 0.0, goal(60.0));
  EXPECT_TRUE(after(progress, 1499.0, goal(60.0)).empty());
  const auto late = after(progress, 1501.0, goal(60.0));
  ASSERT_EQ(late.size(), 1U);
  EXPECT_DOUBLE_EQ(late[0].most_s, 1500.0);
  EXPECT_DOUBLE_EQ(late[0].spent_s, 1501.0);
  EXPECT_TRUE(after(progress, 1600.0, goal(60.0)).empty());
}

TEST(ProgressOfGoals, TimeThatIsExcusedDoesNotCount) {
  Progress progress;
  GoalSight paused = goal(0.0);
  paused.counts = false;
  after(progress, 0.0, paused);
  EXPECT_TRUE(after(progress, 5000.0, paused).empty());
  EXPECT_TRUE(after(progress, 5890.0, goal(0.0)).empty());
  EXPECT_EQ(after(progress, 5910.0, goal(0.0)).size(), 1U);
}

TEST(ProgressOfGoals, WhatARouteTookAtFirstIsWhatItTakes) {
  Progress progress;
  after(progress, 0.0, goal(10.0));
  EXPECT_EQ(after(progress, 1001.0, goal(500.0)).size(), 1U);
}

TEST(ProgressOfGoals, AYieldEndsInThreeMinutes) {
  Progress progress;
  GoalSight yield = goal(500.0);
  yield.kind = GoalKind::yield;
  after(progress, 0.0, yield);
  EXPECT_TRUE(after(progress, 179.0, yield).empty());
  EXPECT_EQ(after(progress, 181.0, yield).size(), 1U);
}

}  // namespace
}  // namespace weft::simulation
