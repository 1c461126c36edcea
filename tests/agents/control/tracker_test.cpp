#include "agents/control/tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/unicycle.hpp"

namespace weft::agents {
namespace {

constexpr double elapsed_s = 1.0 / 30.0;

struct Driven {
  std::vector<TrackError> errors;  // at every sample
  Pose2 end;
  double most_beyond_m = 0.0;
  int samples = 0;
  bool at_end = false;
};

/// Drives `path` (world frame) to its end, the robot being told the exact path.
Driven drive(const std::vector<Pose2>& path, const Pose2& start, const test::UnicycleConfig& base) {
  const TrackerConfig config;
  Tracker tracker;
  test::Unicycle robot(base, start);
  Driven driven;
  double speed = 0.0;
  int standing = 0;
  std::size_t passed = 0;
  for (driven.samples = 0; driven.samples < 3000 && standing < 15; ++driven.samples) {
    const Pose2 robot_from_world = robot.world_from_robot().inverse();
    std::vector<Pose2> robot_from_path;
    for (const Pose2& pose : path) robot_from_path.push_back(robot_from_world * pose);
    // As following does: a stretch of 3 m from a little behind the robot.
    while (passed + 2 < path.size() && robot_from_path[passed + 1].inverse().x > 0.1) ++passed;
    const auto first = robot_from_path.begin() + static_cast<std::ptrdiff_t>(passed);
    const auto last = robot_from_path.end() - first > 15 ? first + 15 : robot_from_path.end();
    const Spline spline = Spline::through({first, last}).value();
    const Tracked tracked = tracker.track(config, spline, 0.6, {speed, true, from_seconds(elapsed_s)});
    driven.errors.push_back(tracked.error);
    driven.at_end = tracked.at_end && last == robot_from_path.end();
    standing = driven.at_end ? standing + 1 : 0;
    robot.drive(tracked.command, elapsed_s);
    speed = robot.last_step().x / elapsed_s;
    const double beyond = (path.back().inverse() * robot.world_from_robot()).x;
    if (driven.at_end || beyond > 0) driven.most_beyond_m = std::max(driven.most_beyond_m, beyond);
  }
  driven.end = robot.world_from_robot();
  return driven;
}

std::vector<Pose2> straight_path(double length_m) {
  std::vector<Pose2> path;
  for (double x = 0; x <= length_m + 1e-9; x += 0.2) path.push_back({x, 0, 0});
  return path;
}

/// Returns a path: straight, a quarter turn of 0.6 m radius, straight.
std::vector<Pose2> corner() {
  std::vector<Pose2> path;
  for (double x = -2.0; x < -0.05; x += 0.2) path.push_back({x, 0, 0});
  for (double angle = 0; angle < M_PI / 2; angle += 0.13) {
    path.push_back({0.6 * std::sin(angle), 0.6 * (1 - std::cos(angle)), angle});
  }
  for (double y = 0.6; y <= 2.6; y += 0.2) path.push_back({0.6, y, M_PI / 2});
  return path;
}

struct BaseCase {
  const char* name;
  test::UnicycleConfig base;
};

class TrackerOnBases : public testing::TestWithParam<BaseCase> {};

TEST_P(TrackerOnBases, ConvergesFromBesideThePathWithoutSwinging) {
  for (const double side : {1.0, -1.0}) {
    const Driven driven = drive(straight_path(6.0), {0.0, 0.2 * side, 0.26 * side}, GetParam().base);
    ASSERT_TRUE(driven.at_end);
    // It may cross the path a little, and each swing is smaller than the one before.
    double first_side = 0.0;
    double other_side = 0.0;
    for (const TrackError& error : driven.errors) {
      first_side = std::max(first_side, side * error.cross_track_m);
      other_side = std::max(other_side, -side * error.cross_track_m);
    }
    EXPECT_LT(first_side, 0.26);
    EXPECT_LT(other_side, 0.03);
    for (std::size_t i = driven.errors.size() * 2 / 3; i < driven.errors.size(); ++i) {
      EXPECT_LT(std::abs(driven.errors[i].cross_track_m), 0.012);
      EXPECT_LT(std::abs(driven.errors[i].heading_rad), 0.03);
    }
  }
}

TEST_P(TrackerOnBases, StopsAtTheEndWithItsHeading) {
  const Driven driven = drive(straight_path(3.0), {0.0, 0.05, 0.0}, GetParam().base);
  ASSERT_TRUE(driven.at_end);
  EXPECT_NEAR(driven.end.x, 3.0, 0.02);
  EXPECT_NEAR(driven.end.y, 0.0, 0.015);
  EXPECT_NEAR(driven.end.heading, 0.0, 0.03);
  EXPECT_LT(driven.most_beyond_m, 0.01);
}

TEST_P(TrackerOnBases, CutsNoCorners) {
  const Driven driven = drive(corner(), {-2.0, 0, 0}, GetParam().base);
  ASSERT_TRUE(driven.at_end);
  double worst = 0.0;
  for (const TrackError& error : driven.errors) worst = std::max(worst, std::abs(error.cross_track_m));
  EXPECT_LT(worst, 0.035);
  EXPECT_NEAR((driven.end.translation() - corner().back().translation()).norm(), 0.0, 0.02);
}

TEST_P(TrackerOnBases, TakesLittleMoreTimeThanTheLimitAllows) {
  const Driven driven = drive(straight_path(6.0), {0, 0, 0}, GetParam().base);
  EXPECT_LT(driven.samples * elapsed_s, 6.0 / 0.6 + 4.0);
}

INSTANTIATE_TEST_SUITE_P(
    Bases, TrackerOnBases,
    testing::Values(BaseCase{"Ideal", {0.0, 0, 0, 0, 0}}, BaseCase{"Lag100ms", {0.1, 1, 0, 0, 0}},
                    BaseCase{"Lag200ms", {0.2, 1, 0, 0, 0}}, BaseCase{"Delay100ms", {0.1, 3, 0, 0, 0}},
                    BaseCase{"Slip5", {0.1, 1, 0.05, 0.05, 0}}, BaseCase{"SlipLagDrift", {0.2, 2, 0.05, 0.05, 0.02}}),
    [](const testing::TestParamInfo<BaseCase>& one) { return one.param.name; });

TEST(Tracker, BackToThePathItTurnsOnTheSpotFirst) {
  const Driven driven = drive(straight_path(4.0), {0.1, 0.0, 3.0}, {0.1, 1, 0, 0, 0});
  ASSERT_TRUE(driven.at_end);
  EXPECT_NEAR(driven.end.x, 4.0, 0.02);
  EXPECT_NEAR(driven.end.y, 0.0, 0.02);
}

TEST(Tracker, ABadBoundIsNamed) {
  TrackerConfig config;
  EXPECT_TRUE(check(config).empty());
  config.steering.heading_gain_1_s = -1;
  config.lag_s = 2;
  const std::vector<Error> issues = check(config);
  ASSERT_EQ(issues.size(), 2U);
  EXPECT_NE(issues[1].message.find("heading_gain_1_s"), std::string::npos);
  EXPECT_NE(issues[0].message.find("lag_s"), std::string::npos);
}

/// Returns how a robot is turned in the end that is only known to be turned, on a way whose bends were told wrong by
/// so many radians a metre: the path is laid out through it.
double turned_at_last(bool knows_aside, double told_wrong_rad_m) {
  const TrackerConfig config;
  Tracker tracker;
  double turned_rad = 0.1;
  double speed_m_s = 0.0;
  for (int i = 0; i < 1500; ++i) {
    std::vector<Pose2> path;
    for (int k = -2; k < 15; ++k)
      path.push_back(Pose2{0.0, 0.0, -turned_rad} * se2_exp({0.2 * k, 0.0, told_wrong_rad_m * 0.2 * k}));
    const Tracked tracked =
        tracker.track(config, Spline::through(path).value(), 0.5, {speed_m_s, knows_aside, from_seconds(elapsed_s)});
    speed_m_s = tracked.command.linear_m_s;
    // The way is straight in truth.
    turned_rad += tracked.command.angular_rad_s * elapsed_s;
  }
  return turned_rad;
}

TEST(Tracker, WhereNobodyKnowsHowFarAsideWhatBendsGetWrongIsMadeUpFor) {
  EXPECT_GT(std::abs(turned_at_last(true, 0.05)), 0.004) << "the gain alone leaves a part of it";
  EXPECT_NEAR(turned_at_last(false, 0.05), 0.0, 0.001);
  EXPECT_NEAR(turned_at_last(false, -0.05), 0.0, 0.001);
}

}  // namespace
}  // namespace weft::agents
