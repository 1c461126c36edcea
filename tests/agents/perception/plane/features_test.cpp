#include <gtest/gtest.h>

#include <Eigen/LU>

#include "agents/perception/plane/feature_pairs.hpp"
#include "agents/perception/plane/geometry.hpp"
#include "agents/perception/plane/guided_match.hpp"
#include "agents/perception/plane/level_points.hpp"
#include "core/random.hpp"
#include "tests/support/flat_floor.hpp"
#include "tests/support/under_ceiling.hpp"

namespace weft::agents {
namespace {

/// Returns a point of the level frame as a feature: rectified by the mount, which knows of no attitude.
PlaneFeature feature_of(const CameraModel& camera, const Attitude& attitude, const Eigen::Vector3d& in_level) {
  const Eigen::Vector2d in_image = test::projected(camera, attitude, in_level);
  PlaneFeature feature;
  feature.above_floor_m = in_level.z();
  feature.on_plane = apply(camera_from_plane(camera, Attitude{}, in_level.z()).inverse(), in_image);
  return feature;
}

TEST(LevelPoints, FeaturesLieWhereTheyAreAtTheirOwnHeights) {
  const CameraModel camera = test::upward_camera(0.03, 0.01);
  const Attitude attitude{0.01, -0.02, 0.002};
  const std::vector<Eigen::Vector3d> truth{
      {1.0, 2.0, test::ceiling_m}, {-2.0, 0.5, test::ceiling_m - 0.8}, {0.3, -1.4, test::ceiling_m}, {0.0, 0.0, 5.1}};
  std::vector<PlaneFeature> features;
  for (const Eigen::Vector3d& point : truth) features.push_back(feature_of(camera, attitude, point));
  const std::vector<Eigen::Vector2d> level = level_points(camera, attitude, features);
  ASSERT_EQ(level.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_LT((level[i] - truth[i].head<2>()).norm(), 1e-9) << i;
    EXPECT_GT((features[i].on_plane - truth[i].head<2>()).norm(), 0.01) << "the attitude was nothing";
  }
  EXPECT_TRUE(level_points(camera, attitude, {}).empty());
}

TEST(FeaturePairs, AreWhereTheImagesHadThemAndAtTheirHeight) {
  const CameraModel camera = test::upward_camera(0.03, 0.01);
  const Eigen::Vector3d point(1.0, 2.0, test::ceiling_m - 0.8);
  const std::vector<PlaneFeature> features{feature_of(camera, {}, {0.0, 0.0, test::ceiling_m}),
                                           feature_of(camera, {}, point)};
  const auto pairs =
      feature_pairs({camera, features}, {camera, features}, std::vector<Match>{{1, 1, 0}, {0, 0, 0}}, 0.01);
  ASSERT_EQ(pairs.size(), 2U);
  const Eigen::Vector2d seen = (camera.robot_from_camera.inverse() * point).hnormalized();
  EXPECT_LT((pairs[0].in_a - seen).norm(), 1e-12);
  EXPECT_LT((pairs[0].in_b - seen).norm(), 1e-12);
  EXPECT_EQ(pairs[0].above_floor_m, point.z());
  EXPECT_EQ(pairs[1].above_floor_m, test::ceiling_m);
  EXPECT_EQ(pairs[0].above_floor_sigma_m, 0.0);
}

TEST(FeaturePairs, TheHeightIsThatOfWhoKnowsItBetter) {
  const CameraModel camera = test::upward_camera();
  std::vector<PlaneFeature> a{feature_of(camera, {}, {0.0, 0.0, 6.0})};
  std::vector<PlaneFeature> b{feature_of(camera, {}, {0.0, 0.0, 6.5})};
  const auto pair = [&](double sigma_a, double sigma_b) {
    a[0].above_floor_sigma_m = sigma_a;
    b[0].above_floor_sigma_m = sigma_b;
    return feature_pairs({camera, a}, {camera, b}, std::vector<Match>{{0, 0, 0}}, 0.01).front();
  };
  EXPECT_NEAR(pair(0.1, 0.2).above_floor_m, 6.1, 1e-12);
  EXPECT_NEAR(pair(0.1, 0.2).above_floor_sigma_m, 0.1 * 0.2 / std::hypot(0.1, 0.2), 1e-12);
  EXPECT_EQ(pair(0.0, 0.2).above_floor_m, 6.0);
  EXPECT_EQ(pair(0.2, 0.0).above_floor_m, 6.5);
  EXPECT_EQ(pair(0.2, 0.0).above_floor_sigma_m, 0.0);
}

TEST(GuidedMatches, TakesTheLikeThatLiesWhereTheGuessHasIt) {
  Random random(6);
  PlaneFeature feature;
  for (std::uint64_t& word : feature.descriptor) word = random.next();
  const std::vector<PlaneFeature> alike(2, feature);
  const std::vector<Eigen::Vector2d> at_a{{1.0, 0.0}, {2.0, 0.0}};
  const std::vector<Eigen::Vector2d> at_b{{1.5, 0.0}, {30.0, 0.0}};
  const auto found = guided_matches({alike, at_a}, {alike, at_b}, {{0.5, 0.0, 0.0}, 0.1, 0.01}, {80, 0.95}, 0.02);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].a, 1U);
  EXPECT_EQ(found[0].b, 0U);
}

}  // namespace
}  // namespace weft::agents
