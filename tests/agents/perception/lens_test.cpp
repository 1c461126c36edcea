#include "agents/perception/lens.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "agents/perception/attitude.hpp"
#include "agents/perception/plane/geometry.hpp"
#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

TEST(Lens, PixelAndRayUndoEachOther) {
  const CameraModel camera = test::paper_camera();
  for (double u = 0.0; u <= 751.0; u += 93.875)
    for (double v = 0.0; v <= 479.0; v += 59.875) {
      const Eigen::Vector2d pixel(u, v);
      const Eigen::Vector2d back = pixel_from_normalised(camera, normalised_from_pixel(camera, pixel));
      EXPECT_LT((back - pixel).norm(), 1e-6) << u << " " << v;
    }
}

CameraModel fisheye() {
  CameraModel camera = test::paper_camera();
  camera.lens = LensModel::equidistant;
  camera.fx = camera.fy = 320.0;
  camera.distortion = {-0.01, 0.004, -0.003, 0.0005, 0.0};
  return camera;
}

TEST(Lens, PixelAndRayUndoEachOtherOfAFisheye) {
  for (double u = 0.0; u <= 751.0; u += 93.875)
    for (double v = 0.0; v <= 479.0; v += 59.875) {
      const Eigen::Vector2d pixel(u, v);
      const Eigen::Vector2d ray = normalised_from_pixel(fisheye(), pixel);
      EXPECT_LT((pixel_from_normalised(fisheye(), ray) - pixel).norm(), 1e-6) << u << " " << v;
    }
}

TEST(Lens, AnEquidistantLensPutsEqualAnglesAtEqualDistances) {
  CameraModel camera = fisheye();
  camera.distortion = {};
  for (const double angle : {0.1, 0.5, 1.0, 1.3}) {
    const Eigen::Vector2d pixel = pixel_from_normalised(camera, {std::tan(angle), 0.0});
    EXPECT_NEAR(pixel.x() - camera.cx, 320.0 * angle, 1e-9);
    EXPECT_NEAR(pixel.y(), camera.cy, 1e-12);
  }
  EXPECT_EQ(normalised_from_pixel(camera, {camera.cx, camera.cy}), Eigen::Vector2d::Zero());
}

TEST(Lens, DistortionMatters) {
  CameraModel straight = test::paper_camera();
  straight.distortion = {};
  const Eigen::Vector2d corner(0.0, 0.0);
  const Eigen::Vector2d difference =
      normalised_from_pixel(test::paper_camera(), corner) - normalised_from_pixel(straight, corner);
  EXPECT_GT(difference.norm() * 460.0, 5.0);
}

TEST(Mount, LooksAheadAndDown) {
  const Pose3 mount = downward_mount(0.15, 0.02, 0.6, 0.735, 0.0, 0.0);
  const Eigen::Vector3d axis = mount.rotation * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(axis.x(), std::cos(0.735), 1e-12);
  EXPECT_NEAR(axis.z(), -std::sin(0.735), 1e-12);
  EXPECT_NEAR((mount.rotation * Eigen::Vector3d::UnitX()).y(), -1.0, 1e-12);  // image right is robot right
  EXPECT_EQ(mount.translation, Eigen::Vector3d(0.15, 0.02, 0.6));
}

TEST(Mount, YawTurnsTheViewToTheLeft) {
  const Pose3 mount = downward_mount(0.0, 0.0, 0.6, 0.735, 0.0, 0.1);
  EXPECT_GT((mount.rotation * Eigen::Vector3d::UnitZ()).y(), 0.05);
}

TEST(Mount, RollTurnsTheImageAboutItsAxis) {
  const Pose3 level = downward_mount(0.0, 0.0, 0.6, 0.735, 0.0, 0.0);
  const Pose3 rolled = downward_mount(0.0, 0.0, 0.6, 0.735, 0.2, 0.0);
  EXPECT_LT((level.rotation * Eigen::Vector3d::UnitZ() - rolled.rotation * Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(level.rotation.angularDistance(rolled.rotation), 0.2, 1e-12);
}

TEST(Mount, ThePapersCameraSeesFrom22CentimetresTo230) {
  CameraModel camera;
  camera.robot_from_camera = downward_mount(0.0, 0.0, 0.6, 0.735, 0.0, 0.0);
  const Eigen::Matrix3d floor_from_camera = camera_from_floor(camera, Attitude{}).inverse();
  EXPECT_NEAR(apply(floor_from_camera, normalised_from_pixel(camera, {375.5, 479.0})).x(), 0.22, 0.02);
  EXPECT_NEAR(apply(floor_from_camera, normalised_from_pixel(camera, {375.5, 0.0})).x(), 2.30, 0.02);
}

TEST(CheckCamera, NamesWhatIsWrong) {
  EXPECT_TRUE(check(test::paper_camera()));
  const auto refused = [](auto&& spoil) {
    CameraModel camera = test::paper_camera();
    spoil(camera);
    const Result<void> checked = check(camera);
    return checked ? std::string() : checked.error().message;
  };
  EXPECT_THAT(refused([](CameraModel& c) { c.fx = 0.0; }), testing::HasSubstr("focal length"));
  EXPECT_THAT(refused([](CameraModel& c) { c.width = 8; }), testing::HasSubstr("size 8x480"));
  EXPECT_THAT(refused([](CameraModel& c) { c.cx = -3.0; }), testing::HasSubstr("centre"));
  EXPECT_THAT(refused([](CameraModel& c) { c.distortion[0] = std::numeric_limits<double>::quiet_NaN(); }),
              testing::HasSubstr("distortion"));
  EXPECT_THAT(refused([](CameraModel& c) { c.distortion[0] = -1.0; }), testing::HasSubstr("not monotone"));
  EXPECT_THAT(refused([](CameraModel& c) { c.robot_from_camera.translation.z() = -0.6; }),
              testing::HasSubstr("above the floor"));
}

}  // namespace
}  // namespace weft::agents
