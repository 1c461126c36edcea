#include "agents/perception/particles/scan_weighing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/agents/perception/particles/room.hpp"

namespace weft::agents {
namespace {

TEST(TemperedPower, IsTheLargestThatLeavesEnough) {
  const std::vector<double> before(100, 0.01);
  std::vector<float> logs(100);
  for (std::size_t i = 0; i < logs.size(); ++i) logs[i] = -0.5F * static_cast<float>(i);
  EXPECT_EQ(tempered_power(before, logs, 1.0, 1.0), 1.0);
  const double power = tempered_power(before, logs, 1.0, 30.0);
  EXPECT_LT(power, 1.0);
  const auto worth = [&](double by) {
    std::vector<double> weights;
    for (const float log : logs) weights.push_back(std::exp(by * static_cast<double>(log)));
    return effective_count(weights);
  };
  EXPECT_GE(worth(power), 30.0);
  EXPECT_LT(worth(power + 0.01), 30.0);
}

/// Weighs particles that a motion of wide errors has spread, by a scan of the room from `truth`.
ParticleSet weighed_after_a_wide_step(const Room& room, const Pose2& truth, const BlurConfig& config, int* blurs) {
  Random random(21);
  const LikelihoodField field = room.field();
  const Scan scan = room.scan_from(truth, random);
  ParticleSet before;
  for (int i = 0; i < 2000; ++i) before.add(truth, 1.0 / 2000);
  const UncertainMotion motion{{0.3, -0.2, 0.4}, Eigen::Vector3d(0.25, 0.25, 0.45).asDiagonal()};
  MovedParticles moved = moved_by(before, motion, random);
  const ScanWeight weight =
      ScanWeighing(config, {}, field, field.ends_of(scan), motion.covariance).weigh(moved, 0, random);
  *blurs = weight.blurs;
  return moved.particles;
}

TEST(ScanWeighing, AScanThatTellsFarMoreThanTheMotionCountsUnblurred) {
  const Room room;
  const Pose2 truth{4.5, 2.9, 0.3};
  int blurs = 0;
  const ParticleEstimate sharp = estimate_of(weighed_after_a_wide_step(room, truth, {}, &blurs), 0.5, 0.1745);
  EXPECT_GT(blurs, 0);
  EXPECT_GT(sharp.share, 0.99);
  EXPECT_LT((sharp.chart_from_robot.translation() - truth.translation()).norm(), 0.03);
  EXPECT_LT(std::sqrt(sharp.covariance(0, 0)), 0.05);
  EXPECT_LT(std::sqrt(sharp.covariance(2, 2)), 0.03);
}

TEST(ScanWeighing, AToldPoseWeighsAsItsCovarianceSays) {
  const Room room;
  const LikelihoodField field = room.field();
  Random random(23);
  const Pose2 expected{4.0, 3.0, 0.0};
  ParticleSet before;
  for (int i = 0; i < 4000; ++i) before.add(expected, 1.0 / 4000);
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal();
  MovedParticles moved = moved_by(before, {{}, covariance}, random);
  const ToldPose told{expected * Pose2{0.1, 0.0, 0.0}, covariance};
  const ScanWeight weight = ScanWeighing({}, {}, field, {}, covariance, told).weigh(moved, 0, random);
  EXPECT_GT(weight.power, 0.0);
  EXPECT_EQ(weight.likelihood, 0.0) << "there was no beam";
  const ParticleEstimate both = estimate_of(moved.particles, 0.5, 0.1745);
  EXPECT_NEAR(both.chart_from_robot.x, 4.05, 0.01);
  EXPECT_NEAR(both.chart_from_robot.y, 3.0, 0.01);
  EXPECT_NEAR(std::sqrt(both.covariance(0, 0)), 0.1 / std::sqrt(2.0), 0.008);
}

TEST(ScanWeighing, AToldPoseFarOffHardlyCounts) {
  const Room room;
  const LikelihoodField field = room.field();
  Random random(24);
  const Pose2 truth{4.5, 2.9, 0.3};
  ParticleSet before;
  for (int i = 0; i < 2000; ++i) before.add(truth, 1.0 / 2000);
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal();
  MovedParticles moved = moved_by(before, {{}, covariance}, random);
  const ToldPose wrong{truth * Pose2{1.5, 0.0, 0.0}, 0.01 * covariance};
  ScanWeighing({}, {}, field, field.ends_of(room.scan_from(truth, random)), covariance, wrong)
      .weigh(moved, 0, random);
  const ParticleEstimate both = estimate_of(moved.particles, 0.5, 0.1745);
  EXPECT_LT((both.chart_from_robot.translation() - truth.translation()).norm(), 0.04);
}

TEST(ScanWeighing, AtOnceIsEnoughWhereTheMotionTellsAsMuch) {
  const Room room;
  Random random(22);
  const Pose2 truth{4.5, 2.9, 0.3};
  const LikelihoodField field = room.field();
  ParticleSet before;
  for (int i = 0; i < 500; ++i) before.add(truth, 1.0 / 500);
  const Eigen::Matrix3d covariance = Eigen::Vector3d(1e-3, 1e-3, 1e-4).asDiagonal();
  MovedParticles moved = moved_by(before, {{}, covariance}, random);
  const ParticleSet as_moved = moved.particles;
  ScanWeighing weighing({}, {}, field, field.ends_of(room.scan_from(truth, random)), covariance);
  const ScanWeight weight = weighing.weigh(moved, 0, random);
  EXPECT_EQ(weight.blurs, 0);
  EXPECT_EQ(weight.power, 1.0);
  EXPECT_EQ(moved.particles.x, as_moved.x);
  EXPECT_GT(weight.likelihood, 0.5);
}

}  // namespace
}  // namespace weft::agents
