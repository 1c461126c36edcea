#include "agents/perception/scene_inliers.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr double kSceneFocalPx = 386.0;
constexpr std::uint32_t kPoints = 80;

/// Places the optical frame (x right, y down, z ahead) in the world.
using Camera = Eigen::Isometry3d;

Camera camera(double ahead_m, double turned, double pitched, double rolled) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return Eigen::Translation3d(0.0, 0.0, ahead_m) * AngleAxisd(turned, Vector3d::UnitY()) *
         AngleAxisd(pitched, Vector3d::UnitX()) * AngleAxisd(rolled, Vector3d::UnitZ());
}

UprightFeature seen_by(const Camera& world_from_camera, const Eigen::Vector3d& point, Random& random) {
  const Eigen::Vector3d at = world_from_camera.inverse() * point;
  UprightFeature feature;
  feature.pixel = {static_cast<float>(kSceneFocalPx * at.x() / at.z() + random.normal(0.0, 0.4)),
                   static_cast<float>(kSceneFocalPx * at.y() / at.z() + random.normal(0.0, 0.4))};
  return feature;
}

/// Counts the inliers of pairs of points about 4 m away; those of another scene are up to 25 px too high or too low.
std::uint32_t inliers(const Camera& first, const Camera& second, bool one_scene, std::uint64_t seed) {
  Random random(seed);
  std::vector<UprightFeature> a, b;
  std::vector<Match> same;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const double z = random.uniform(3.0, 5.0);
    const Eigen::Vector3d point(random.uniform(-0.4, 0.4) * z, random.uniform(-0.3, 0.1) * z, z);
    a.push_back(seen_by(first, point, random));
    b.push_back(seen_by(second, point, random));
    if (!one_scene) b.back().pixel.y() += static_cast<float>(random.uniform(-25.0, 25.0));
    same.push_back({i, i, 0});
  }
  return scene_inliers(a, b, same, kSceneFocalPx, 1.0);
}

constexpr std::uint32_t kMostOf80 = 55;  // with a noise of 0.6 px between both

TEST(SceneInliers, AreMostOfOneSceneSeenFromNearby) {
  EXPECT_GT(inliers(camera(0.0, 0.0, 0.0, 0.0), camera(0.15, 0.02, 0.02, 0.01), true, 1), kMostOf80);
}

TEST(SceneInliers, DoNotMindACameraThatLooksFurtherDown) {
  for (const double pitched : {-0.12, 0.12})
    EXPECT_GT(inliers(camera(0.0, 0.0, 0.05, 0.0), camera(0.0, 0.0, 0.05 + pitched, 0.0), true, 2), kMostOf80);
}

TEST(SceneInliers, DoNotMindACameraThatIsRolledInItsMount) {
  for (const double rolled : {-0.04, 0.04})
    EXPECT_GT(inliers(camera(0.0, 0.0, 0.05, 0.0), camera(0.0, 0.0, 0.05, rolled), true, 3), kMostOf80);
}

TEST(SceneInliers, DoNotMindAPitchedCameraThatIsTurned) {
  for (const double turned : {-0.25, 0.25})
    EXPECT_GT(inliers(camera(0.0, 0.0, -0.15, 0.0), camera(0.0, turned, -0.15, 0.0), true, 4), kMostOf80);
}

TEST(SceneInliers, DoNotMindAStepAsideBetweenRacks) {
  Random random(5);
  std::vector<UprightFeature> a, b;
  std::vector<Match> same;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const double ahead = random.uniform(3.5, 8.0);  // racks 1.5 m to either side
    const Eigen::Vector3d point(random.chance(0.5) ? 1.5 : -1.5, random.uniform(-0.3, 0.1) * ahead, ahead);
    a.push_back(seen_by(camera(0.0, 0.0, 0.0, 0.0), point, random));
    b.push_back(seen_by(Eigen::Translation3d(0.2, 0.0, 0.0) * camera(0.1, -0.05, 0.0, 0.0), point, random));
    same.push_back({i, i, 0});
  }
  EXPECT_GT(scene_inliers(a, b, same, kSceneFocalPx, 1.0), 50U);
}

TEST(SceneInliers, AreFewOfScenesThatOnlyLookAlike) {
  for (std::uint64_t seed = 10; seed < 30; ++seed)
    EXPECT_LT(inliers(camera(0.0, 0.0, 0.0, 0.0), camera(0.0, 0.0, 0.0, 0.0), false, seed), 15U) << seed;
}

TEST(SceneInliers, AreNoneOfTooFewPairs) {
  EXPECT_EQ(scene_inliers({}, {}, {}, kSceneFocalPx, 1.0), 0U);
}

}  // namespace
}  // namespace weft::agents
