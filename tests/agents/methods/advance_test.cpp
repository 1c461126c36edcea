#include "agents/methods/advance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr double kScale = 0.01;  // one sigma of all distances
constexpr double kNoiseM = 0.002;

/// Returns a step of that motion, with noise and an error of scale.
Step step_of(const Pose2& moved) {
  Step step;
  step.seen = true;
  const Eigen::Vector3d xi = se2_log(moved);
  step.common.col(0).head<2>() = kScale * xi.head<2>();
  Metric2 relation{moved, in_plane(step.common) * in_plane(step.common).transpose()};
  relation.covariance.diagonal() += Eigen::Vector3d(kNoiseM * kNoiseM, kNoiseM * kNoiseM, 1e-8);
  step.previous_from_current = relation;
  return step;
}

double sigma_ahead(const Relation& relation) {
  return std::sqrt(planar_covariance(relation)(0, 0));
}

TEST(Advance, WhatStepsHaveInCommonGrowsWithTheWayTheRestByItsRoot) {
  Relation start_from_robot = Metric2{};
  CommonErrors common = CommonErrors::Zero();
  for (int i = 0; i < 100; ++i) start_from_robot = advanced(start_from_robot, step_of({0.1, 0, 0}), common);
  EXPECT_NEAR(planar(start_from_robot).x, 10.0, 1e-9);
  EXPECT_NEAR(common(0, 0), kScale * 10.0, 1e-9);
  EXPECT_NEAR(sigma_ahead(start_from_robot), std::hypot(kScale * 10.0, kNoiseM * 10.0), 1e-6);
}

TEST(Advance, ThereAndBackTheCommonErrorIsNone) {
  Relation start_from_robot = Metric2{};
  CommonErrors common = CommonErrors::Zero();
  start_from_robot = advanced(start_from_robot, step_of({1.0, 0, 0}), common);
  EXPECT_GT(sigma_ahead(start_from_robot), kScale);
  start_from_robot = advanced(start_from_robot, step_of({-1.0, 0, 0}), common);
  EXPECT_TRUE(common.isZero(1e-12));
  EXPECT_NEAR(sigma_ahead(start_from_robot), kNoiseM * std::sqrt(2.0), 1e-9);
}

/// Shows, for robots with a scale of their own each and noise on top, that they are off as far as is stated.
TEST(Advance, StatesHowFarRobotsAreOffAfterACurve) {
  constexpr int kRobots = 2000;
  const Pose2 moved = se2_exp({0.1, 0.0, 0.05});
  Relation stated = Metric2{};
  CommonErrors common = CommonErrors::Zero();
  for (int i = 0; i < 40; ++i) stated = advanced(stated, step_of(moved), common);
  Random random(3);
  Eigen::Matrix3d off = Eigen::Matrix3d::Zero();
  for (int robot = 0; robot < kRobots; ++robot) {
    const double scale = 1.0 + kScale * random.normal();
    Pose2 truly;
    for (int i = 0; i < 40; ++i) {
      const Eigen::Vector3d noise(kNoiseM * random.normal(), kNoiseM * random.normal(), 1e-4 * random.normal());
      truly = truly * se2_exp({scale * 0.1, 0.0, 0.05}) * se2_exp(noise);
    }
    const Eigen::Vector3d xi = se2_log(planar(stated).inverse() * truly);
    off += xi * xi.transpose() / kRobots;
  }
  const Eigen::Matrix3d covariance = planar_covariance(stated);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(std::sqrt(off(i, i) / covariance(i, i)), 1.0, 0.08) << i;
}

TEST(Advance, EveryKindOfRelationStaysValid) {
  for (const Relation& start : {Relation{Metric2{}}, Relation{Metric3{}}, Relation{AlongPath{}}}) {
    Relation a_from_robot = start;
    CommonErrors common = CommonErrors::Zero();
    for (const double metres : {0.3, 0.2, -0.4, 0.1})
      a_from_robot = advanced(a_from_robot, step_of({metres, 0, 0.2}), common);
    EXPECT_TRUE(check(a_from_robot)) << start.index();
    EXPECT_EQ(a_from_robot.index(), start.index());
  }
}

/// Shows that up a ramp an error of scale lies along the ramp, in z as well.
TEST(Advance, InSpaceWhatStepsHaveInCommonGrowsInAllSixDimensions) {
  constexpr double kSteep = 0.1;  // rad
  Step step;
  step.seen = true;
  step.common(0, 0) = kScale * 0.1;
  Matrix6d covariance = 1e-10 * Matrix6d::Identity();
  covariance(0, 0) += step.common(0, 0) * step.common(0, 0);
  step.previous_from_current = Metric3{lift({0.1, 0.0, 0.0}), covariance};
  const Pose3 ramp{Eigen::Quaterniond(Eigen::AngleAxisd(-kSteep, Eigen::Vector3d::UnitY())), Eigen::Vector3d::Zero()};
  Relation start_from_robot = Metric3{ramp, {}};
  CommonErrors common = CommonErrors::Zero();
  for (int i = 0; i < 100; ++i) start_from_robot = advanced(start_from_robot, step, common);
  const auto& up = std::get<Metric3>(start_from_robot);
  EXPECT_NEAR(up.a_from_b.translation.z(), 10.0 * std::sin(kSteep), 1e-9);
  EXPECT_NEAR(common(0, 0), kScale * 10.0, 1e-9);
  EXPECT_NEAR(std::sqrt(up.covariance.matrix()(0, 0)), kScale * 10.0, 1e-4) << "along the robot's own axis";
  EXPECT_TRUE(check(start_from_robot));
  const Metric3 measured{up.a_from_b, 0.25 * up.covariance.matrix()};
  EXPECT_NEAR(corrected(common, up, measured)(0, 0), 0.25 * kScale * 10.0, 1e-4);
}

TEST(Joined, TwoStepsAreOne) {
  Step blind = step_of({0.2, 0, 0});
  blind.seen = false;
  blind.blind_reason = "few_tracks";
  const Step both = joined(blind, step_of({0.1, 0, 0}));
  EXPECT_FALSE(both.seen);
  EXPECT_EQ(both.blind_reason, "few_tracks");
  EXPECT_NEAR(both.common(0, 0), kScale * 0.3, 1e-12);
  EXPECT_NEAR(sigma_ahead(both.previous_from_current), std::hypot(kScale * 0.3, kNoiseM * std::sqrt(2.0)), 1e-9);
}

TEST(Corrected, AsMuchIsLeftAsIsBelievedOfThePrediction) {
  Metric2 before;
  before.covariance.diagonal() << 4e-4, 4e-4, 4e-4;
  Metric2 after = before;
  after.covariance *= 0.25;
  CommonErrors common = CommonErrors::Zero();
  common(0, 0) = 0.01;
  EXPECT_NEAR(corrected(common, before, after)(0, 0), 0.0025, 1e-9);
}

}  // namespace
}  // namespace weft::agents
