#include "agents/perception/stereo/rectifier.hpp"

#include <gmock/gmock.h>

#include "agents/perception/lens.hpp"
#include "tests/support/stereo_room.hpp"

namespace weft::agents {
namespace {

using testing::HasSubstr;

/// Returns a pair as it comes from a bench: lenses that bend, the right camera askew.
Sensor bent_sensor() {
  Sensor sensor = test::stereo_sensor(320, 240, 220.0, 0.12);
  sensor.camera.distortion = {-0.28, 0.07, 0.0002, 0.00002, 0.0};
  sensor.right->distortion = {-0.27, 0.06, -0.0001, 0.0001, 0.0};
  sensor.right->fx = 223.0;
  sensor.right->cx += 4.0;
  sensor.right->robot_from_camera =
      sensor.right->robot_from_camera *
      Pose3{Eigen::Quaterniond(Eigen::AngleAxisd(0.03, Eigen::Vector3d(0.5, 0.7, 0.4).normalized())),
            {0.0, 0.002, 0.001}};
  return sensor;
}

TEST(Rectifier, APointIsSeenOnOneRowDisplacedByItsDepth) {
  const Sensor sensor = bent_sensor();
  const auto made = Rectifier::make(sensor);
  ASSERT_TRUE(made) << made.error().message;
  const StereoRig& rig = made->rig();
  EXPECT_NEAR(rig.baseline_m, 0.12, 1e-3);
  for (const Eigen::Vector3d& in_rig : {Eigen::Vector3d(0.3, -0.2, 2.0), {-0.5, 0.1, 3.0}, {0.02, 0.03, 0.9}}) {
    const Eigen::Vector3d in_robot = rig.robot_from_camera * in_rig;
    const Eigen::Vector3d in_left = sensor.camera.robot_from_camera.inverse() * in_robot;
    const Eigen::Vector3d in_right = sensor.right->robot_from_camera.inverse() * in_robot;
    const Eigen::Vector2d left = made->rectified_left(pixel_from_normalised(sensor.camera, in_left.hnormalized()));
    const Eigen::Vector2d right = made->rectified_right(pixel_from_normalised(*sensor.right, in_right.hnormalized()));
    EXPECT_NEAR(left.y(), right.y(), 1e-6);
    EXPECT_NEAR(left.x() - right.x(), rig.disparity_px(in_rig.z()), 1e-6);
    EXPECT_NEAR((rig.point_of(left.x(), left.y(), left.x() - right.x()) - in_rig).norm(), 0.0, 1e-6);
    EXPECT_NEAR((made->taken_left(left) - pixel_from_normalised(sensor.camera, in_left.hnormalized())).norm(), 0.0,
                1e-6);
  }
}

TEST(Rectifier, AllThatIsRectifiedWasSeenByBoth) {
  const auto made = Rectifier::make(bent_sensor());
  ASSERT_TRUE(made);
  const StereoRig& rig = made->rig();
  for (const auto& [u, v] :
       {std::pair{0, 0}, {rig.width - 1, 0}, {0, rig.height - 1}, {rig.width - 1, rig.height - 1}})
    for (const Eigen::Vector2d& at :
         {made->taken_left(Eigen::Vector2d(u, v)), made->taken_right(Eigen::Vector2d(u, v))}) {
      EXPECT_GE(at.x(), -0.5);
      EXPECT_GE(at.y(), -0.5);
      EXPECT_LE(at.x(), rig.width - 0.5);
      EXPECT_LE(at.y(), rig.height - 0.5);
    }
}

TEST(Rectifier, ARectifiedPairIsLeftAsItIs) {
  const Sensor sensor = test::stereo_sensor(320, 240, 208.0, 0.12);
  const auto made = Rectifier::make(sensor);
  ASSERT_TRUE(made);
  EXPECT_TRUE(made->is_rectified());
  EXPECT_DOUBLE_EQ(made->rig().focal_px, 208.0);
  EXPECT_DOUBLE_EQ(made->rig().cx, sensor.camera.cx);
  const auto pixels = std::make_shared<const Bytes>(320 * 240, std::uint8_t{7});
  const StereoPair pair{{320, 240, pixels}, {320, 240, pixels}};
  EXPECT_EQ(made->rectified(pair).left.pixels, pixels);
  EXPECT_FALSE(made->fits({{320, 240, pixels}, {160, 240, pixels}}));
}

TEST(Rectifier, ABentPairOfARoomIsTheRoomThroughPinholes) {
  const Sensor sensor = bent_sensor();
  const auto made = Rectifier::make(sensor);
  ASSERT_TRUE(made);
  const test::StereoRoom room = test::crate_room();
  const Pose3 at = lift(Pose2{1.0, 0.0, 0.0});
  test::StereoShot clean;
  clean.noise = 0.0;
  const StereoPair rectified = made->rectified(room.pair(sensor, at, clean));
  CameraModel pinhole = sensor.camera;
  pinhole.distortion = {};
  pinhole.fx = pinhole.fy = made->rig().focal_px;
  pinhole.cx = made->rig().cx;
  pinhole.cy = made->rig().cy;
  const Image direct = room.look(pinhole, at * made->rig().robot_from_camera, clean).image;
  double off = 0.0;
  double spread = 0.0;
  for (std::size_t i = 0; i < direct.pixels->size(); ++i) {
    off += std::abs((*direct.pixels)[i] - (*rectified.left.pixels)[i]);
    spread += std::abs((*direct.pixels)[i] - 110.0);
  }
  EXPECT_LT(off, 0.2 * spread);
}

TEST(Rectifier, WhatIsNoPairIsNamed) {
  Sensor alone = test::stereo_sensor(320, 240, 208.0, 0.12);
  alone.right.reset();
  EXPECT_THAT(Rectifier::make(alone).error().message, HasSubstr("no right camera"));
  Sensor swapped = test::stereo_sensor(320, 240, 208.0, 0.12);
  std::swap(swapped.camera.robot_from_camera, swapped.right->robot_from_camera);
  EXPECT_THAT(Rectifier::make(swapped).error().message, HasSubstr("right order"));
  Sensor sizes = test::stereo_sensor(320, 240, 208.0, 0.12);
  sizes.right->width = 640;
  EXPECT_THAT(Rectifier::make(sizes).error().message, HasSubstr("320x240"));
  Sensor squinting = test::stereo_sensor(320, 240, 208.0, 0.12);
  squinting.right->robot_from_camera.rotation =
      squinting.right->robot_from_camera.rotation * Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitY());
  EXPECT_THAT(Rectifier::make(squinting).error().message, HasSubstr("at most 0.35"));
}

}  // namespace
}  // namespace weft::agents
