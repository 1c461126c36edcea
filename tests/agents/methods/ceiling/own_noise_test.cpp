#include "agents/methods/ceiling/own_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "agents/perception/lens.hpp"
#include "core/random.hpp"
#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"

namespace weft::agents {
namespace {

constexpr double kStatedPx = 0.15;
constexpr double kCeilingM = 6.4;
const PlanarState kTruth{{0.3, 0.02, 0.05}, {}, {}};

std::vector<PlanePair> pairs_with(const CameraModel& camera, double noise_px, std::uint64_t seed) {
  Random random(seed);
  const double sigma = noise_px / focal_px(camera);
  std::vector<PlanePair> pairs;
  for (int i = 0; i < 80; ++i) {
    const Eigen::Vector2d in_a(random.uniform(-0.9, 0.9), random.uniform(-0.7, 0.7));
    const Reprojection there = reproject(camera, camera, kTruth, in_a, kCeilingM);
    const Eigen::Vector2d noise(random.normal(0.0, sigma), random.normal(0.0, sigma));
    PlanePair pair{in_a, there.in_b + noise, kStatedPx};
    pair.above_floor_m = kCeilingM;
    pairs.push_back(pair);
  }
  return pairs;
}

/// Returns a prior of two views that hardly lean, each by itself.
AttitudePrior still() {
  constexpr double sigma = 0.0009;
  AttitudePrior prior;
  prior.information.diagonal().setConstant(1.0 / (sigma * sigma));
  return prior;
}

TEST(OwnNoise, IsSeenWhereItIsMoreThanStatedAndLeavesThePriorItsSay) {
  const CameraModel camera = test::up_camera();
  constexpr double noise_px = 1.5;
  double squares = 0.0;
  constexpr int trials = 10;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    std::vector<PlanePair> pairs = pairs_with(camera, noise_px, seed);
    const PlanarFit fit = fit_with_own_noise(camera, pairs, kStatedPx, still(), {});
    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(pairs.front().sigma_px, noise_px, 0.35 * noise_px);
    EXPECT_NEAR(fit.scale, noise_px / kStatedPx, 0.35 * noise_px / kStatedPx);
    squares += std::pow(fit.state.attitude_b.pitch_rad, 2) + std::pow(fit.state.attitude_b.roll_rad, 2);
  }
  EXPECT_LT(std::sqrt(squares / (2 * trials)), 0.0006) << "as if the stated noise were right it is 0.001 and more";
}

TEST(OwnNoise, IsAsStatedWhereItIsNoMore) {
  const CameraModel camera = test::up_camera();
  std::vector<PlanePair> pairs = pairs_with(camera, 0.1, 3);
  const PlanarFit fit = fit_with_own_noise(camera, pairs, kStatedPx, still(), {});
  EXPECT_EQ(pairs.front().sigma_px, kStatedPx);
  EXPECT_LT(fit.scale, 1.0);
}

}  // namespace
}  // namespace weft::agents
