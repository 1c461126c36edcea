#include "agents/control/grid/local_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "agents/control/grid/overlay.hpp"

namespace weft::agents {
namespace {

const Raster kChart = square_raster({0.0, 0.0}, 10.0, 0.05);

OccupancyGrid open_chart() {
  return {kChart, std::vector<CellState>(kChart.size(), CellState::free)};
}

void fill(OccupancyGrid& grid, double x0, double y0, double x1, double y1, CellState state) {
  for (int row = 0; row < grid.raster.rows; ++row) {
    for (int column = 0; column < grid.raster.columns; ++column) {
      const Eigen::Vector2d centre = grid.raster.centre({column, row});
      if (centre.x() > x0 && centre.x() < x1 && centre.y() > y0 && centre.y() < y1)
        grid.cells[grid.raster.index({column, row})] = state;
    }
  }
}

const OccupancyGrid kNothingSeen = unknown_grid(square_raster({0.0, 0.0}, 6.0, 0.05));

LocalTask task_to(double x, double y, const Pose2& robot = {}) {
  LocalTask task;
  task.chart_from_robot = robot;
  task.chart_goal = {x, y};
  return task;
}

/// Holds what came of driving by plans in a plane without errors, commands obeyed at once.
struct PlannedDrive {
  Pose2 end;
  double driven_m = 0.0;
  double least_m = 1e9;  ///< room around the robot
  std::string_view stopped;
  bool is_there = false;
};

PlannedDrive drive(const OccupancyGrid& chart, LocalTask task, double for_s) {
  const LocalPlanConfig config;
  PlannedDrive driven;
  const DistanceMap room = clearance_of(chart);
  for (double t = 0.0; t < for_s; t += config.arcs.period_s) {
    const auto plan = plan_locally(config, chart, kNothingSeen, task);
    if (!plan) {
      driven.stopped = plan.error().reason;
      break;
    }
    driven.is_there = plan->is_there;
    if (plan->is_there) break;
    task.moving = plan->command;
    const double period = config.arcs.period_s;
    task.chart_from_robot = task.chart_from_robot *
                            se2_exp({plan->command.linear_m_s * period, 0.0, plan->command.angular_rad_s * period});
    driven.driven_m += plan->command.linear_m_s * period;
    driven.least_m = std::min(driven.least_m, room.at(task.chart_from_robot.translation()));
  }
  driven.end = task.chart_from_robot;
  return driven;
}

TEST(LocalPlan, DrivesStraightThroughAnOpenChart) {
  const PlannedDrive driven = drive(open_chart(), task_to(3.0, 1.0), 20.0);
  EXPECT_TRUE(driven.is_there) << driven.stopped;
  EXPECT_LT(driven.driven_m, 1.1 * std::hypot(3.0, 1.0));
}

TEST(LocalPlan, GoesRoundAWall) {
  OccupancyGrid chart = open_chart();
  fill(chart, 1.0, -1.0, 1.1, 1.5, CellState::occupied);
  const PlannedDrive driven = drive(chart, task_to(2.5, 0.0), 30.0);
  EXPECT_TRUE(driven.is_there) << driven.stopped;
  EXPECT_GE(driven.least_m, LocalPlanConfig{}.footprint_m);
  EXPECT_LT(driven.driven_m, 5.5);
}

TEST(LocalPlan, AnUnknownCellIsAWall) {
  OccupancyGrid chart = open_chart();
  fill(chart, 1.0, -5.0, 1.3, 5.0, CellState::unknown);
  const auto plan = plan_locally({}, chart, kNothingSeen, task_to(2.5, 0.0));
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().reason, "no_way");
  fill(chart, 1.0, -0.6, 1.3, 0.6, CellState::free);
  EXPECT_TRUE(drive(chart, task_to(2.5, 0.0), 30.0).is_there) << "through the gap that is known";
}

TEST(LocalPlan, ADoorNarrowerThanTheRobotIsNone) {
  OccupancyGrid chart = open_chart();
  fill(chart, 1.0, -5.0, 1.1, 5.0, CellState::occupied);
  fill(chart, 1.0, -0.25, 1.1, 0.25, CellState::free);
  EXPECT_EQ(drive(chart, task_to(2.5, 0.0), 10.0).stopped, "no_way");
  fill(chart, 1.0, -0.45, 1.1, 0.45, CellState::free);
  EXPECT_TRUE(drive(chart, task_to(2.5, 0.0), 30.0).is_there);
}

TEST(LocalPlan, WhatTheCostmapHasMarkedIsGoneRound) {
  OccupancyGrid costmap = kNothingSeen;
  fill(costmap, 1.0, -0.3, 1.4, 0.3, CellState::occupied);
  const auto before = plan_locally({}, open_chart(), kNothingSeen, task_to(2.5, 0.0));
  const auto after = plan_locally({}, open_chart(), costmap, task_to(2.5, 0.0));
  ASSERT_TRUE(before && after);
  const auto farthest_aside = [](const LocalPlan& plan) {
    double aside = 0.0;
    for (const Eigen::Vector2d& point : plan.chart_path) aside = std::max(aside, std::abs(point.y()));
    return aside;
  };
  EXPECT_LT(farthest_aside(*before), 0.1);
  EXPECT_GE(farthest_aside(*after), 0.6);
}

TEST(LocalPlan, ARobotBesideAWallMayLeaveItAndNotPressOn) {
  OccupancyGrid chart = open_chart();
  fill(chart, 0.2, -5.0, 0.4, 5.0, CellState::occupied);
  const PlannedDrive driven = drive(chart, task_to(-2.0, 0.0), 30.0);
  EXPECT_TRUE(driven.is_there) << driven.stopped;
  EXPECT_GE(driven.least_m, clearance_of(chart).at(Eigen::Vector2d(0.0, 0.0)) - 1e-6);
}

TEST(LocalPlan, TurnsOnTheSpotToAGoalBehind) {
  const auto plan = plan_locally({}, open_chart(), kNothingSeen, task_to(-2.0, 0.3));
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->command.linear_m_s, 0.0);
  EXPECT_GT(plan->command.angular_rad_s, 0.0);
  EXPECT_TRUE(drive(open_chart(), task_to(-2.0, 0.3), 30.0).is_there);
}

TEST(LocalPlan, ARobotOffTheChartOrAGoalInAWallHasNoPlan) {
  EXPECT_EQ(plan_locally({}, open_chart(), kNothingSeen, task_to(0.0, 0.0, {7.0, 0.0, 0.0})).error().reason,
            "off_the_chart");
  OccupancyGrid chart = open_chart();
  fill(chart, 2.0, -1.0, 4.0, 1.0, CellState::occupied);
  EXPECT_EQ(plan_locally({}, chart, kNothingSeen, task_to(3.0, 0.0)).error().reason, "no_way");
}

TEST(Arcs, StopBeforeWhatTheyWouldEndIn) {
  OccupancyGrid chart = open_chart();
  fill(chart, 0.75, -5.0, 0.9, 5.0, CellState::occupied);
  const DistanceMap clearance = clearance_of(chart);
  const RoomToDrive room(clearance, 0.3, {0.0, 0.0});
  const ArcConfig config;
  const ChosenArc fast = choose_arc(config, room, {}, {0.5, 0.0}, {2.0, 0.0}, 0.5);
  EXPECT_LT(fast.command.linear_m_s, 0.5) << "0.45 m are left, of which it needs 0.36 from 0.5 m/s";
  EXPECT_LE(stop_distance_m(config, fast.command.linear_m_s), fast.clear_m);
  EXPECT_NEAR(stop_distance_m(config, 0.5), 0.25 / 1.2 + 0.1 + 0.05, 1e-9);
}

TEST(Arcs, KeepWithinWhatTheBaseCanDo) {
  const OccupancyGrid chart = open_chart();
  const DistanceMap clearance = clearance_of(chart);
  const RoomToDrive room(clearance, 0.3, {0.0, 0.0});
  const ArcConfig config;
  for (const double speed : {0.0, 0.2, 0.5}) {
    for (const double turn : {-0.6, 0.0, 0.9}) {
      const ChosenArc arc = choose_arc(config, room, {}, {speed, turn}, {0.7, 0.5}, 0.5);
      EXPECT_LE(arc.command.linear_m_s, speed + config.acceleration_m_s2 * config.period_s + 1e-9);
      EXPECT_GE(arc.command.linear_m_s, speed - config.deceleration_m_s2 * config.period_s - 1e-9);
      EXPECT_LE(std::abs(arc.command.angular_rad_s - turn), config.acceleration_rad_s2 * config.period_s + 1e-9);
      EXPECT_LE(std::abs(arc.command.angular_rad_s), config.fastest_rad_s);
    }
  }
}

TEST(LocalPlan, SettingsOutOfBoundsAreNamed) {
  LocalPlanConfig config;
  EXPECT_TRUE(check(config).empty());
  config.arcs.speeds = 1;
  ASSERT_EQ(check(config).size(), 1U);
  EXPECT_NE(check(config)[0].message.find("local_plan: arcs.speeds is 1"), std::string::npos);
}

}  // namespace
}  // namespace weft::agents
