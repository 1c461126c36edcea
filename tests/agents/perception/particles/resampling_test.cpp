#include "agents/perception/particles/resampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "agents/perception/particles/motion_sampling.hpp"
#include "agents/perception/particles/pose_cells.hpp"

namespace weft::agents {
namespace {

/// Returns particles of one cell each, in a row.
ParticleSet in_a_row(std::size_t count) {
  ParticleSet particles;
  for (std::size_t i = 0; i < count; ++i)
    particles.add({0.25 + 0.5 * static_cast<double>(i), 0.25, 0.0}, 1.0 / static_cast<double>(count));
  return particles;
}

TEST(Kld, CountsAreThoseOfFox) {
  KldConfig config;
  config.least = 10;
  config.most = 1'000'000;
  // n = chi^2 quantile of k - 1 degrees of freedom at 99 % over 2 epsilon; the quantiles from tables.
  const auto of_quantile = [&](double quantile) { return quantile / (2.0 * config.epsilon); };
  EXPECT_NEAR(static_cast<double>(kld_count(config, 11)), of_quantile(23.209), 2.0);
  EXPECT_NEAR(static_cast<double>(kld_count(config, 31)), of_quantile(50.892), 2.0);
  EXPECT_NEAR(static_cast<double>(kld_count(config, 101)), of_quantile(135.807), 2.0);
}

TEST(Kld, CountsStayWithinTheirBounds) {
  const KldConfig config;
  EXPECT_EQ(kld_count(config, 0), 300U);
  EXPECT_EQ(kld_count(config, 1), 300U);
  EXPECT_EQ(kld_count(config, 3), 300U);
  EXPECT_EQ(kld_count(config, 100'000), 3000U);
}

TEST(Kld, ManyParticlesInOnePlaceNeedFew) {
  const KldConfig config;
  Random random(4);
  ParticleSet together = in_a_row(2000);
  for (std::size_t i = 0; i < together.size(); ++i) together.set(i, {0.2, 0.2, 0.0});
  EXPECT_EQ(count_needed(config, together, random), 300U);
  EXPECT_EQ(count_needed(config, in_a_row(3000), random), 3000U);
  const std::size_t between = count_needed(config, in_a_row(60), random);
  EXPECT_NEAR(static_cast<double>(between), 871.0, 30.0) << "59 degrees of freedom: 87.166 / 0.1";
}

TEST(Kld, ParticlesFromAnywhereNeedMany) {
  Random random(4);
  ParticleSet together = in_a_row(300);
  for (std::size_t i = 0; i < together.size(); ++i) together.set(i, {0.2, 0.2, 0.0});
  const DrawPose anywhere = [](Random& draws) {
    return Pose2{draws.uniform(0.0, 30.0), draws.uniform(0.0, 30.0), draws.uniform(-3.0, 3.0)};
  };
  EXPECT_EQ(count_needed({}, together, random, 0.3, anywhere), 3000U);
}

TEST(PoseCells, HeadingsMeetAtPi) {
  const PoseCells cells(0.5, 0.1745);
  const PoseCell before = cells.at({0.0, 0.0, std::numbers::pi - 0.01});
  const PoseCell after = cells.at({0.0, 0.0, -std::numbers::pi + 0.01});
  EXPECT_EQ((before.turn + 1) % cells.turns(), after.turn);
  EXPECT_EQ(cells.at({-0.01, 0.01, 0.0}).column, -1);
}

TEST(CellNumbers, CountEachOnce) {
  CellNumbers numbers(1000);
  std::set<std::size_t> seen;
  for (int round = 0; round < 2; ++round)
    for (int i = 0; i < 1000; ++i) seen.insert(numbers.number({i % 40 - 20, i / 40, i % 7}));
  EXPECT_EQ(seen.size(), 1000U);
  EXPECT_EQ(numbers.count(), 1000U);
  EXPECT_EQ(numbers.find({500, 0, 0}), CellNumbers::kNone);
}

TEST(Resampling, IsUnbiasedAndOfLowVariance) {
  ParticleSet particles = in_a_row(7);
  particles.weight = {0.05, 0.3, 0.0, 0.011, 0.25, 0.2, 0.189};
  constexpr std::size_t kCount = 20;
  constexpr int kRounds = 4000;
  std::vector<double> drawn(7, 0.0);
  Random random(11);
  for (int round = 0; round < kRounds; ++round) {
    const ParticleSet again = resample(particles, kCount, random);
    ASSERT_EQ(again.size(), kCount);
    std::vector<int> times(7, 0);
    for (std::size_t i = 0; i < kCount; ++i) ++times[static_cast<std::size_t>(again.x[i] / 0.5F)];
    for (std::size_t i = 0; i < 7; ++i) {
      const double wanted = kCount * particles.weight[i];
      ASSERT_GE(times[i], std::floor(wanted - 1e-9));
      ASSERT_LE(times[i], std::ceil(wanted + 1e-9));
      drawn[i] += times[i];
    }
  }
  for (std::size_t i = 0; i < 7; ++i)
    EXPECT_NEAR(drawn[i] / kRounds, kCount * particles.weight[i], 4.0 * 0.5 / std::sqrt(kRounds)) << i;
}

TEST(Resampling, TheSameSeedDrawsTheSame) {
  const ParticleSet particles = in_a_row(50);
  Random one(3);
  Random other(3);
  EXPECT_EQ(resample(particles, 30, one).x, resample(particles, 30, other).x);
}

TEST(Inject, ReplacesTheShareAsked) {
  ParticleSet particles = in_a_row(10'000);
  Random random(5);
  inject(
      particles, 0.2,
      [](Random&) {
        return Pose2{-1.0, 0.0, 0.0};
      },
      random);
  const auto replaced = std::count(particles.x.begin(), particles.x.end(), -1.0F);
  EXPECT_NEAR(static_cast<double>(replaced), 2000.0, 4.0 * 40.0);
  EXPECT_NEAR(effective_count(particles.weight), 10'000.0, 1e-6);
}

TEST(MotionSampling, ErrorsHaveTheCovarianceOfTheStep) {
  ParticleSet particles = in_a_row(20'000);
  for (std::size_t i = 0; i < particles.size(); ++i) particles.set(i, {1.0, 2.0, 0.7});
  UncertainMotion motion{{0.3, 0.0, 0.1}, Eigen::Matrix3d::Zero()};
  motion.covariance << 4e-4, 0.0, 0.0, 0.0, 1e-4, 5e-5, 0.0, 5e-5, 4e-4;
  Random random(8);
  move(particles, motion, random);
  const ParticleEstimate estimate = estimate_of(particles, 0.5, 0.1745);
  const Pose2 wanted = Pose2{1.0, 2.0, 0.7} * motion.previous_from_current;
  EXPECT_NEAR(estimate.chart_from_robot.x, wanted.x, 1e-3);
  EXPECT_NEAR(estimate.chart_from_robot.y, wanted.y, 1e-3);
  EXPECT_NEAR(estimate.chart_from_robot.heading, wanted.heading, 1e-3);
  EXPECT_LT((estimate.covariance - motion.covariance).norm(), 0.04 * motion.covariance.norm());
  EXPECT_NEAR(estimate.share, 1.0, 1e-9);
}

TEST(MotionSampling, StepsAddUpAsOne) {
  UncertainMotion step{{0.1, 0.02, 0.3}, Eigen::Matrix3d::Identity() * 1e-4};
  const UncertainMotion two = step * step;
  EXPECT_NEAR(two.previous_from_current.heading, 0.6, 1e-12);
  EXPECT_GT(two.covariance(1, 1), 2e-4) << "the first one's heading moves the end of the second one aside";
  EXPECT_NEAR(two.covariance(2, 2), 2e-4, 1e-12);
}

TEST(Estimate, IsThatOfTheHeaviestClusterAndNotOfTheMiddle) {
  ParticleSet particles;
  for (int i = 0; i < 40; ++i) particles.add({0.0, 0.0, 3.1}, 0.015);
  for (int i = 0; i < 40; ++i) particles.add({8.0, 0.0, -3.1}, 0.01);
  const ParticleEstimate estimate = estimate_of(particles, 0.5, 0.1745);
  EXPECT_NEAR(estimate.chart_from_robot.x, 0.0, 1e-6);
  EXPECT_NEAR(estimate.share, 0.6, 1e-9);
}

TEST(Estimate, HeadingsAverageAcrossPi) {
  ParticleSet particles;
  particles.add({0.0, 0.0, std::numbers::pi - 0.05}, 0.5);
  particles.add({0.0, 0.0, -std::numbers::pi + 0.03}, 0.5);
  const Pose2 mean = estimate_of(particles, 0.5, 0.1745).chart_from_robot;
  EXPECT_NEAR(wrap_angle(mean.heading - (std::numbers::pi - 0.01)), 0.0, 1e-5);
}

}  // namespace
}  // namespace weft::agents
