#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "agents/perception/lens.hpp"
#include "agents/perception/mount.hpp"
#include "agents/perception/planar_motion.hpp"
#include "agents/perception/plane/one_plane.hpp"
#include "core/random.hpp"
#include "tests/support/flat_floor.hpp"
#include "tests/support/under_ceiling.hpp"

/// Tests motion under a ceiling 6.4 m above a camera that leans by 2 degrees, and under what hangs from it.
namespace weft::agents {
namespace {

const CameraModel kLeaning = test::upward_camera(2.0 * test::degree);

Eigen::Vector3d moved_to_b(const Pose2& a_from_b, const Eigen::Vector3d& in_a) {
  Eigen::Vector3d in_b = in_a;
  in_b.head<2>() = a_from_b.inverse() * Eigen::Vector2d(in_a.head<2>());
  return in_b;
}

/// Returns points at the heights that `height(i)` gives, as both views see them, told of no height.
template <class Height>
std::vector<PlanePair> pairs_at(const CameraModel& camera, const PlanarState& state, const Height& height,
                                Random& random, double noise_px = 0.0) {
  std::vector<PlanePair> pairs;
  for (int i = 0; i < 120; ++i) {
    const Eigen::Vector3d in_a(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0), height(i));
    const Eigen::Vector2d noise = noise_px / focal_px(camera) * Eigen::Vector2d(random.normal(), random.normal());
    pairs.push_back({test::projected(camera, state.attitude_a, in_a),
                     test::projected(camera, state.attitude_b, moved_to_b(state.a_from_b, in_a)) + noise, 0.15});
    pairs.back().above_floor_m = test::ceiling_m;
  }
  return pairs;
}

AttitudePrior shaken() {
  AttitudePrior prior;
  prior.information.diagonal() << 1e6, 1e6, 1e6, 1e6, 1e6, 1e6;
  return prior;
}

double hung(int i) {
  return i % 2 == 0 ? test::ceiling_m : test::ceiling_m - 0.8;
}

double off_by_m(const PlanarFit& fit, const PlanarState& truth) {
  return (truth.a_from_b.inverse() * fit.state.a_from_b).translation().norm();
}

const PlanarState kMovedBelow{{0.4, 0.03, 0.1}, {0.002, -0.001, 0.001}, {-0.001, 0.002, -0.001}};

TEST(PlaneHeights, WhatHangsBelowTheCeilingIsPredictedWhereItIsSeen) {
  const Eigen::Vector3d in_a(1.3, -0.7, test::ceiling_m - 0.8);
  const Eigen::Vector2d from = test::projected(kLeaning, kMovedBelow.attitude_a, in_a);
  const Eigen::Vector2d to =
      test::projected(kLeaning, kMovedBelow.attitude_b, moved_to_b(kMovedBelow.a_from_b, in_a));
  const Reprojection there = reproject(kLeaning, kLeaning, kMovedBelow, from, test::ceiling_m - 0.8);
  EXPECT_TRUE(there.in_front);
  EXPECT_LT((there.in_b - to).norm(), 1e-12);
  const Reprojection as_ceiling = reproject(kLeaning, kLeaning, kMovedBelow, from, test::ceiling_m);
  EXPECT_GT(focal_px(kLeaning) * (as_ceiling.in_b - to).norm(), 1.5);
}

TEST(PlaneHeights, ThePlaneBehindTheCameraIsNotInFront) {
  EXPECT_FALSE(reproject(kLeaning, kLeaning, kMovedBelow, {0.1, 0.1}, 0.0).in_front);
  EXPECT_FALSE(
      reproject(test::paper_camera(), test::paper_camera(), kMovedBelow, {0.1, 0.1}, test::ceiling_m).in_front);
}

TEST(PlaneHeights, DerivativesMatchDifferences) {
  constexpr double h = 1e-6;
  const Eigen::Vector2d from(0.3, -0.2);
  const Reprojection here = reproject(kLeaning, kLeaning, kMovedBelow, from, test::ceiling_m);
  const auto at = [&](const Vector9d& d, double height_m) {
    const PlanarState state{kMovedBelow.a_from_b * se2_exp(d.head<3>()),
                            Attitude::from(kMovedBelow.attitude_a.vector() + d.segment<3>(3)),
                            Attitude::from(kMovedBelow.attitude_b.vector() + d.tail<3>())};
    return reproject(kLeaning, kLeaning, state, from, height_m).in_b;
  };
  for (int k = 0; k < 9; ++k) {
    const Vector9d aside = h * Vector9d::Unit(k);
    const Eigen::Vector2d numeric = (at(aside, test::ceiling_m) - at(-aside, test::ceiling_m)) / (2.0 * h);
    EXPECT_LT((here.jacobian.col(k) - numeric).norm(), 1e-6) << "parameter " << k;
  }
  const Eigen::Vector2d numeric =
      (at(Vector9d::Zero(), test::ceiling_m + h) - at(Vector9d::Zero(), test::ceiling_m - h)) / (2 * h);
  EXPECT_LT((here.by_height - numeric).norm(), 1e-6);
}

TEST(PlaneHeights, TheMotionIsFoundWhenHeightsAreKnown) {
  Random random(3);
  std::vector<PlanePair> pairs = pairs_at(kLeaning, kMovedBelow, hung, random);
  const PlanarFit as_one_plane = fit_planar_motion(kLeaning, kLeaning, pairs, shaken(), {});
  EXPECT_GT(off_by_m(as_one_plane, kMovedBelow), 0.005);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].above_floor_m = hung(static_cast<int>(i));
  const AttitudePrior truth{
      (Vector6d() << kMovedBelow.attitude_a.vector(), kMovedBelow.attitude_b.vector()).finished(),
      shaken().information};
  const PlanarFit fit = fit_planar_motion(kLeaning, kLeaning, pairs, truth, {});
  ASSERT_TRUE(fit.converged);
  EXPECT_LT(off_by_m(fit, kMovedBelow), 1e-5);
}

TEST(PlaneHeights, HeightsThatAreNotKnownCountByTheirSigma) {
  const PlanarState state{{0.4, 0.03, 0.1}, {}, {}};
  double certain_m = 0.0;
  double doubted_m = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    std::vector<PlanePair> pairs = pairs_at(kLeaning, state, hung, random, 0.15);
    certain_m += off_by_m(fit_planar_motion(kLeaning, kLeaning, pairs, shaken(), {}), state);
    for (std::size_t i = 1; i < pairs.size(); i += 2) pairs[i].above_floor_sigma_m = 0.8;
    doubted_m += off_by_m(fit_planar_motion(kLeaning, kLeaning, pairs, shaken(), {}), state);
  }
  EXPECT_LT(doubted_m, 0.2 * certain_m);
}

TEST(PlaneHeights, ADoubtedHeightCountsAcrossItsLineAlone) {
  PlanePair pair{{0.0, 0.0}, {0.0, 0.0}, 0.5};
  EXPECT_EQ(pair.discount({3.0, 4.0}), Eigen::Matrix2d::Identity());
  pair.above_floor_sigma_m = 0.8;
  const Eigen::Vector2d along = Eigen::Vector2d(3.0, 4.0) / 5.0;
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Matrix2d discount = pair.discount(5.0 * along);
  EXPECT_LT((discount * across - across).norm(), 1e-12);
  // 0.8 m move it by 4 px, which is 8 sigmas.
  EXPECT_LT((discount * along - along / std::sqrt(65.0)).norm(), 1e-12);
}

TEST(OnePlaneAbove, IsTheCeilingAndNotTheFloor) {
  Random random(4);
  const PlanarState state{{1.2, 0.1, 0.1}, {}, {}};
  const std::vector<PlanePair> pairs = pairs_at(
      kLeaning, state, [](int) { return test::ceiling_m; }, random);
  EXPECT_EQ(one_plane(kLeaning, {}, {}, pairs, 1.5, test::ceiling_m).refused, "");
  EXPECT_EQ(one_plane(kLeaning, {}, {}, pairs, 1.5, 0.0).refused, "normal_refused");
}

TEST(MountFilterBelowACeiling, FindsTheTiltOfAMountThatIsGivenAsStraight) {
  const CameraModel given = test::upward_camera();
  MountFilter filter(given, {.tilt_rad = 0.1, .focal_share = 1e-6});
  Random random(5);
  for (int i = 0; i < 30; ++i) {
    const Pose2 moved = se2_exp(Eigen::Vector3d(1.0, 0.0, 0.2 * random.normal()));
    std::vector<PlanePair> pairs = pairs_at(kLeaning, {moved, {}, {}}, hung, random, 0.15);
    for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k].above_floor_m = hung(static_cast<int>(k));
    ASSERT_TRUE(filter.add({pairs, moved, moved}));
  }
  EXPECT_NEAR(filter.tilt().pitch_rad, 2.0 * test::degree, 0.05 * test::degree);
  EXPECT_NEAR(filter.tilt().roll_rad, 0.0, 0.05 * test::degree);
}

}  // namespace
}  // namespace weft::agents
