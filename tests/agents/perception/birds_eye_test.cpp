#include "agents/perception/birds_eye.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/random.hpp"
#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

class BirdsEyeTest : public testing::Test {
 protected:
  RectifiedPlane look(const Pose2& floor_from_robot, std::uint64_t seed) const {
    test::Shot shot;
    shot.seed = seed;
    return birds_eye_.rectify(eye_.render(floor_, floor_from_robot, {}, shot), 600, 0.018);
  }

  test::FlatFloor floor_ = test::FlatFloor::procedural(22, 4.5, 3.5);
  CameraModel camera_ = test::paper_camera();
  test::FloorCamera eye_{camera_};
  BirdsEye birds_eye_{camera_, {}};
};

TEST_F(BirdsEyeTest, FeaturesLieWhereTheFloorHasThem) {
  const Pose2 first{1.0, 1.7, 0.0};
  const Pose2 first_from_second{0.2, 0.1, 0.4};
  const RectifiedPlane a = look(first, 1);
  const RectifiedPlane b = look(first * first_from_second, 2);
  ASSERT_EQ(a.features.size(), 600U);
  std::vector<Descriptor> da;
  std::vector<Descriptor> db;
  for (const PlaneFeature& f : a.features) da.push_back(f.descriptor);
  for (const PlaneFeature& f : b.features) db.push_back(f.descriptor);
  int right = 0;
  int turned = 0;
  for (const Match& m : match_descriptors(da, db, {60, 0.85})) {
    const PlaneFeature& fa = a.features[m.a];
    const PlaneFeature& fb = b.features[m.b];
    if ((first_from_second * fb.on_plane - fa.on_plane).norm() > 0.006) continue;
    ++right;
    turned += std::abs(wrap_angle(fa.heading_rad - fb.heading_rad - first_from_second.heading)) < 0.3 ? 1 : 0;
  }
  EXPECT_GT(right, 80);
  EXPECT_GT(turned, 0.9 * right) << "a feature's heading turns with the robot";
}

TEST_F(BirdsEyeTest, ThePatchIsSmallAndCoversTheArea) {
  const PlanePatch patch = look({1.0, 1.7, 0.0}, 1).patch;
  EXPECT_EQ(patch.pixels.size(), static_cast<std::size_t>(patch.width * patch.height));
  EXPECT_LT(patch.pixels.size(), 10000U);
  EXPECT_NEAR(patch.width * patch.metres_per_pixel, 1.8, 0.05);
  EXPECT_NEAR(patch.first_pixel_on_plane.x(), 1.5, 0.02);
  EXPECT_NEAR(patch.first_pixel_on_plane.y(), 0.9, 0.02);
}

TEST_F(BirdsEyeTest, SameImageSameFeatures) {
  const RectifiedPlane a = look({1.0, 1.7, 0.0}, 1);
  const RectifiedPlane b = look({1.0, 1.7, 0.0}, 1);
  ASSERT_EQ(a.features.size(), b.features.size());
  for (std::size_t i = 0; i < a.features.size(); ++i) EXPECT_EQ(a.features[i].descriptor, b.features[i].descriptor);
  EXPECT_EQ(a.patch.pixels, b.patch.pixels);
}

TEST_F(BirdsEyeTest, CornersOfNoiseAreLeftOutWhereAsked) {
  Random random(7);
  auto pixels =
      std::make_shared<Bytes>(static_cast<std::size_t>(camera_.width) * static_cast<std::size_t>(camera_.height));
  for (std::uint8_t& pixel : *pixels) pixel = static_cast<std::uint8_t>(std::lround(100.0 + 2.0 * random.normal()));
  const Image blank{camera_.width, camera_.height, pixels};
  BirdsEyeArea area;
  area.least_contrast = 2.5;
  const BirdsEye wary(camera_, area);
  EXPECT_GT(birds_eye_.rectify(blank, 600, 0.018).features.size(), 500U);
  EXPECT_LT(wary.rectify(blank, 600, 0.018).features.size(), 60U);
  const Image floor = eye_.render(floor_, {1.0, 1.7, 0.0}, {}, {});
  EXPECT_EQ(wary.rectify(floor, 600, 0.018).features.size(), 600U) << "a floor's corners stay";
}

/// Tests a ceiling 1.6 m above the camera, all round the robot.
TEST(BirdsEyeAbove, FeaturesLieWhereTheCeilingHasThem) {
  constexpr double kCeilingM = 2.0;
  const test::FlatFloor ceiling = test::FlatFloor::procedural(23, 7.0, 6.0);
  const CameraModel camera = test::upward_camera(0.035);
  const test::FloorCamera eye(camera, kCeilingM);
  const BirdsEye birds_eye(camera, {1.2, 1.0, 0.005, -1.2, kCeilingM});
  const Pose2 first{3.0, 3.0, 0.0};
  const Pose2 first_from_second{0.2, 0.1, 0.4};
  const RectifiedPlane a = birds_eye.rectify(eye.render(ceiling, first, {}, {}), 300, 0.05);
  const RectifiedPlane b = birds_eye.rectify(eye.render(ceiling, first * first_from_second, {}, {}), 300, 0.05);
  EXPECT_NEAR(a.patch.height * a.patch.metres_per_pixel, 2.4, 0.06) << "behind the robot as well as ahead";
  int right = 0;
  int turned = 0;
  bool is_behind = false;
  for (const Match& m : match_descriptors(descriptors_of(a.features), descriptors_of(b.features), {60, 0.85})) {
    const PlaneFeature& fa = a.features[m.a];
    const PlaneFeature& fb = b.features[m.b];
    EXPECT_EQ(fa.above_floor_m, kCeilingM);
    if ((first_from_second * fb.on_plane - fa.on_plane).norm() > 0.01) continue;
    ++right;
    turned += std::abs(wrap_angle(fa.heading_rad - fb.heading_rad - first_from_second.heading)) < 0.3 ? 1 : 0;
    is_behind = is_behind || fa.on_plane.x() < -0.5;
  }
  EXPECT_GT(right, 40);
  EXPECT_GT(turned, 0.9 * right);
  EXPECT_TRUE(is_behind);
}

}  // namespace
}  // namespace weft::agents
