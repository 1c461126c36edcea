#include "agents/methods/ceiling/common_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "agents/perception/mount.hpp"
#include "agents/perception/planar_motion.hpp"
#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"
#include "tests/support/under_ceiling.hpp"

/// Tests what all steps have wrong alike against odometry's own fit, through a mount that is off.
namespace weft::agents {
namespace {

constexpr double kTiltRad = 0.004;
const CameraModel kLeaning = test::up_camera(0.15, 0.05);

/// Returns how the fit of a motion errs that was seen by a camera whose mount is truly another one.
Eigen::Vector3d error_of_fit(const CameraModel& given, const CameraModel& real, const Pose2& moved) {
  std::vector<PlanePair> pairs;
  for (double x = -3.5; x <= 5.5; x += 0.5) {
    for (double y = -5.0; y <= 4.0; y += 0.5) {
      const Eigen::Vector2d in_b = moved.inverse() * Eigen::Vector2d(x, y);
      pairs.push_back({test::projected(real, {}, {x, y, test::ceiling_m}),
                       test::projected(real, {}, {in_b.x(), in_b.y(), test::ceiling_m}), 0.15});
      pairs.back().above_floor_m = test::ceiling_m;
    }
  }
  AttitudePrior prior;
  prior.information.diagonal() << 1e12, 1e12, 1e12, 1e12, 1e12, 1e12;
  const PlanarFit fit = fit_planar_motion(given, given, pairs, prior, {moved, {}, {}});
  EXPECT_TRUE(fit.converged);
  return se2_log(fit.state.a_from_b.inverse() * moved);
}

/// Returns what is stated of one sigma of pitch and of roll that a drive has not shown, over that motion.
Eigen::Matrix<double, 3, 2> stated(const Pose2& moved) {
  CeilingConfig config;
  const Eigen::Matrix2d known =
      (kTiltRad * kTiltRad - kHangingTiltRad * kHangingTiltRad) * Eigen::Matrix2d::Identity();
  return common_errors(config, kLeaning, {test::ceiling_m, 0.02}, moved, known).middleCols<2>(4);
}

TEST(CeilingCommonErrors, ATiltLooksLikeATurn) {
  const Pose2 ahead{0.6, 0.0, 0.0};
  const Eigen::Matrix<double, 3, 2> said = stated(ahead);
  Eigen::Matrix<double, 3, 2> seen;
  seen.col(0) = error_of_fit(kLeaning, tilted(kLeaning, kTiltRad, 0.0), ahead);
  seen.col(1) = error_of_fit(kLeaning, tilted(kLeaning, 0.0, kTiltRad), ahead);
  // Columns may come in any order and turned among themselves: what they make together counts.
  const Eigen::Matrix3d said2 = said * said.transpose();
  const Eigen::Matrix3d seen2 = seen * seen.transpose();
  EXPECT_NEAR(std::sqrt(said2(2, 2)), std::sqrt(seen2(2, 2)), 0.3 * std::sqrt(seen2(2, 2)));
  EXPECT_GE(std::sqrt(said2(0, 0)), std::sqrt(seen2(0, 0)));      // of the scale no less is stated than is seen
  EXPECT_GT(std::sqrt(seen2(2, 2)), 0.4 * 0.6 * kTiltRad / 6.2);  // half of the tilt over a way of the height
}

TEST(CeilingCommonErrors, ATiltPutsThePointAboveTheRobotAsideInBends) {
  const Eigen::Matrix<double, 3, 2> said = stated({0.0, 0.0, 0.25});
  const double aside_m = 0.25 * kTiltRad * (test::ceiling_m - kLeaning.robot_from_camera.translation.z());
  EXPECT_NEAR(said.topRows<2>().norm(), std::sqrt(2.0) * aside_m, 1e-4);
  EXPECT_NEAR(said.row(2).norm(), 0.0, 1e-12);
}

TEST(CeilingCommonErrors, WhatDrivesNeverShowOfTheTiltAndTheScaleStays) {
  const Pose2 ahead{1.0, 0.0, 0.0};
  const PlanarErrors errors = common_errors({}, kLeaning, {test::ceiling_m, 1e-6}, ahead, Eigen::Matrix2d::Zero());
  const double away_m = test::ceiling_m - kLeaning.robot_from_camera.translation.z();
  EXPECT_GT(errors.row(2).norm(), 0.4 * kHangingTiltRad / away_m);
  EXPECT_GT(std::abs(errors(0, 0)), 0.005);
}

}  // namespace
}  // namespace weft::agents
