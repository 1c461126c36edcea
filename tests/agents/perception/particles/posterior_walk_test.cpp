#include "agents/perception/particles/posterior_walk.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::agents {
namespace {

/// Returns particles that all came to one pose, as if they had been resampled down to it.
MovedParticles all_at(const Pose2& expected, const Pose2& pose, std::size_t count) {
  MovedParticles moved;
  for (std::size_t i = 0; i < count; ++i) {
    moved.expected.add(expected, 1.0 / static_cast<double>(count));
    moved.particles.add(pose, 1.0 / static_cast<double>(count));
  }
  return moved;
}

TEST(PosteriorWalk, LeadsFromOnePoseToTheProductOfMotionAndLikelihood) {
  const Pose2 expected{3.0, 1.0, 0.0};
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.04, 0.01, 0.01).asDiagonal();
  constexpr double seen_x_m = 3.3;
  constexpr double sigma_m = 0.1;
  const LogLikelihood log_likelihood = [&](const ParticleSet& particles) {
    std::vector<float> logs;
    for (const float x : particles.x)
      logs.push_back(static_cast<float>(-0.5 * std::pow((static_cast<double>(x) - seen_x_m) / sigma_m, 2)));
    return logs;
  };
  MovedParticles moved = all_at(expected, expected, 4000);
  Random random(3);
  const std::vector<float> logs =
      PosteriorWalk(covariance).walk(moved, log_likelihood, Eigen::Matrix3d::Identity(), 60, random);
  EXPECT_EQ(logs, log_likelihood(moved.particles));
  const ParticleEstimate estimate = estimate_of(moved.particles, 1.0, 0.5);
  // Product of normal distributions: variance 1 / (1 / .04 + 1 / .01), mean in proportion.
  EXPECT_NEAR(estimate.chart_from_robot.x, 3.0 + 0.3 * 0.8, 0.01);
  EXPECT_NEAR(std::sqrt(estimate.covariance(0, 0)), std::sqrt(0.008), 0.01);
  EXPECT_NEAR(std::sqrt(estimate.covariance(1, 1)), 0.1, 0.01);
  EXPECT_NEAR(std::sqrt(estimate.covariance(2, 2)), 0.1, 0.01);
}

TEST(PosteriorWalk, StaysWhereTheMotionHadNoError) {
  MovedParticles moved = all_at({1.0, 2.0, 0.5}, {1.0, 2.0, 0.5}, 200);
  const LogLikelihood rightwards = [](const ParticleSet& particles) { return particles.x; };
  Random random(4);
  PosteriorWalk(Eigen::Matrix3d::Zero()).walk(moved, rightwards, Eigen::Matrix3d::Identity(), 20, random);
  for (std::size_t i = 0; i < moved.particles.size(); ++i) EXPECT_LT(std::abs(moved.particles.x[i] - 1.0F), 0.01F);
}

}  // namespace
}  // namespace weft::agents
