#include "agents/control/spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace weft::agents {
namespace {

std::vector<Pose2> circle(double radius_m, double step_rad, int count) {
  std::vector<Pose2> poses;
  for (int i = 0; i < count; ++i) {
    const double angle = step_rad * i;
    poses.push_back({radius_m * std::sin(angle), radius_m * (1.0 - std::cos(angle)), angle});
  }
  return poses;
}

TEST(Spline, PassesEachPoseAtItsHeading) {
  const std::vector<Pose2> poses{{0, 0, 0}, {0.2, 0.01, 0.1}, {0.4, 0.05, 0.2}, {0.55, 0.15, 0.9}};
  const auto spline = Spline::through(poses);
  ASSERT_TRUE(spline);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PathPoint point = spline->at(spline->along_of(i));
    EXPECT_NEAR(point.pose.x, poses[i].x, 1e-9);
    EXPECT_NEAR(point.pose.y, poses[i].y, 1e-9);
    EXPECT_NEAR(point.pose.heading, poses[i].heading, 1e-6);
  }
}

TEST(Spline, DirectionDoesNotJumpWherePiecesMeet) {
  const auto spline = Spline::through({{0, 0, 0}, {0.2, 0.02, 0.3}, {0.35, 0.12, 0.7}, {0.4, 0.3, 1.3}});
  ASSERT_TRUE(spline);
  for (std::size_t i = 1; i + 1 < spline->size(); ++i) {
    const double along = spline->along_of(i);
    const Pose2 before = spline->at(along - 1e-6).pose;
    const Pose2 after = spline->at(along + 1e-6).pose;
    EXPECT_NEAR((before.translation() - after.translation()).norm(), 0.0, 1e-5);
    EXPECT_NEAR(wrap_angle(before.heading - after.heading), 0.0, 1e-4);
  }
}

TEST(Spline, FollowsACircleWithItsLengthAndCurvature) {
  const double radius = 1.0;
  const auto spline = Spline::through(circle(radius, 0.2, 16));
  ASSERT_TRUE(spline);
  EXPECT_NEAR(spline->length_m(), 15 * 0.2 * radius, 0.01);
  for (double along = 0.1; along < spline->length_m() - 0.1; along += 0.07) {
    const PathPoint point = spline->at(along);
    EXPECT_NEAR((point.pose.translation() - Eigen::Vector2d(0, radius)).norm(), radius, 1e-3);
    EXPECT_NEAR(point.curvature_1_m, 1.0 / radius, 0.1);
  }
}

TEST(Spline, CuttingThePathElsewhereDoesNotMoveAPiece) {
  const std::vector<Pose2> poses = circle(1.5, 0.13, 12);
  const auto whole = Spline::through(poses);
  const auto part = Spline::through({poses.begin() + 3, poses.begin() + 9});
  ASSERT_TRUE(whole && part);
  const double start = whole->along_of(3);
  for (double along = 0.0; along < part->length_m(); along += 0.05) {
    EXPECT_NEAR((whole->at(start + along).pose.translation() - part->at(along).pose.translation()).norm(), 0, 1e-6);
  }
}

TEST(Spline, NearestGivesWhereAPointStandsBesideThePath) {
  const auto spline = Spline::through({{0, 0, 0}, {0.5, 0, 0}, {1.0, 0, 0}});
  ASSERT_TRUE(spline);
  EXPECT_NEAR(spline->nearest({0.62, 0.2}, -1, 2), 0.62, 1e-6);
  EXPECT_NEAR(spline->nearest({-0.3, 0.1}, -1, 2), -0.3, 1e-6);
  EXPECT_NEAR(spline->nearest({1.4, -0.1}, -1, 2), 1.4, 1e-6);
  EXPECT_NEAR(spline->nearest({1.4, -0.1}, -1, 1.1), 1.0, 0.1 + 1e-6);
}

TEST(Spline, BeyondItsEndsItGoesStraightOn) {
  const auto spline = Spline::through({{0, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(spline);
  EXPECT_NEAR(spline->at(1.25).pose.x, 1.25, 1e-9);
  EXPECT_NEAR(spline->at(-0.25).pose.x, -0.25, 1e-9);
}

TEST(Spline, RefusesWhatIsNoPath) {
  EXPECT_FALSE(Spline::through({}));
  EXPECT_FALSE(Spline::through({{0, 0, 0}, {0.0005, 0, 0}}));
  EXPECT_FALSE(Spline::through({{0, 0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}}));
  EXPECT_TRUE(Spline::through({{1, 2, 3}}));
}

}  // namespace
}  // namespace weft::agents
