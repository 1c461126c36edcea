// The simulated rooms that registration is judged in, and what it must never do there: seeds that nothing was set by.
#include "clients/evaluate/registration/trials.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::evaluate::registration {
namespace {

/// Sums up how the points of a place lie along x of the world.
struct PlaceCloudSpread {
  std::size_t points = 0;
  double mean_x = 0.0;
  double sigma_x = 0.0;

  explicit PlaceCloudSpread(const MadePlace& place) : points(place.cloud.points.size()) {
    double squares = 0.0;
    for (const Eigen::Vector3f& point : place.cloud.points) {
      const double x = (place.world_from_place * point.cast<double>()).x();
      mean_x += x / static_cast<double>(points);
      squares += x * x / static_cast<double>(points);
    }
    sigma_x = std::sqrt(squares - mean_x * mean_x);
  }
};

TEST(RegistrationScene, RaysMeetTheNearestBox) {
  Scene scene;
  scene.boxes.push_back({{2.0, -1.0, 0.0}, {3.0, 1.0, 2.0}, 1.0});
  scene.boxes.push_back({{5.0, -1.0, 0.0}, {6.0, 1.0, 2.0}, 1.0});
  const auto met = first_met(scene, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 10.0);
  ASSERT_TRUE(met);
  EXPECT_EQ(met->box, 0U);
  EXPECT_NEAR(met->distance, 2.0, 1e-12);
  EXPECT_FALSE(first_met(scene, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 1.5));
  EXPECT_FALSE(first_met(scene, {0.0, 0.0, 1.0}, {-1.0, 0.0, 0.0}, 10.0));
  EXPECT_FALSE(first_met(scene, {0.0, 1.5, 1.0}, {1.0, 0.0, 0.0}, 10.0));
}

TEST(StereoRun, DepthIsOffAsTheFormulaSays) {
  Scene scene;  // a wall across the way, 4 m ahead
  scene.boxes.push_back({{4.0, -9.0, 0.0}, {4.2, 9.0, 3.0}, 1.0});
  StereoRig rig;
  rig.wild_share = 0.0;
  rig.bias_sigma_px = 0.0;
  rig.patch_sigma_px = 0.0;
  rig.range_m = 6.0;
  Random random(3);
  const auto places = run_through(scene, {-1.0, 0.0, 0.0}, 1.0, 0.5, rig, random);
  ASSERT_EQ(places.size(), 1U);
  const PlaceCloudSpread spread(places[0]);
  EXPECT_GT(spread.points, 300U);
  EXPECT_NEAR(spread.mean_x, 4.0, 0.03);
  EXPECT_LT(spread.sigma_x, rig.noise().sigma_m(4.6)) << "a voxel is the mean of several frames";
  EXPECT_GT(spread.sigma_x, 0.2 * rig.noise().sigma_m(4.0));
}

TEST(StereoRun, APlainWallHasNoPointsAndTheSameSeedTheSameClouds) {
  Scene scene;
  scene.boxes.push_back({{4.0, -9.0, 0.0}, {4.2, 9.0, 3.0}, 0.0});
  Random random(3);
  EXPECT_TRUE(run_through(scene, {-1.0, 0.0, 0.0}, 1.0, 0.5, {}, random).at(0).cloud.points.empty());
  const auto points = [] {
    Random seed(9);
    const Scene room = made_scene(SceneKind::room, seed);
    return run_through(room, room.start, 1.0, 0.5, {}, seed).at(0).cloud.points;
  };
  EXPECT_EQ(points(), points());
}

TEST(RegistrationTrials, NoEdgeOfARoomOrAnAisleIsMadeWorseByMuch) {
  for (const SceneKind kind : {SceneKind::room, SceneKind::aisle, SceneKind::plain}) {
    const std::vector<Trial> trials = edge_trials(kind, 501, EdgePrior{}, {});
    ASSERT_GE(trials.size(), 4U);
    for (const Trial& trial : trials) {
      EXPECT_LT(trial.after.metres(), trial.before.metres() + 0.04) << name_of(kind);
      EXPECT_LT(trial.after.heading_rad, trial.before.heading_rad + 0.01) << name_of(kind);
    }
  }
}

TEST(RegistrationTrials, EdgesOfAnAisleGainAcrossIt) {
  double before_m = 0.0;
  double after_m = 0.0;
  for (const Trial& trial : edge_trials(SceneKind::aisle, 501, EdgePrior{}, {})) {
    before_m += trial.before.across_m;
    after_m += trial.after.across_m;
  }
  EXPECT_LT(after_m, 0.8 * before_m);
}

TEST(RegistrationTrials, StitchesThatAreJoinedWherePillarsTellHowFarAreNear) {
  std::size_t joined = 0;
  for (const Trial& trial : stitch_trials(SceneKind::aisle, 502, {}, {})) {
    if (!trial.refused.empty()) continue;
    ++joined;
    EXPECT_LT(trial.after.metres(), 0.04);
    EXPECT_LT(kDegrees * trial.after.heading_rad, 0.5);
  }
  EXPECT_GE(joined, 3U);
}

TEST(RegistrationTrials, StitchesSlideAlongPlainAisles) {
  const std::vector<Trial> trials = stitch_trials(SceneKind::plain, 502, {}, {});
  EXPECT_FALSE(trials.empty());
  for (const Trial& trial : trials) EXPECT_EQ(trial.refused, "slides");
}

}  // namespace
}  // namespace weft::evaluate::registration
