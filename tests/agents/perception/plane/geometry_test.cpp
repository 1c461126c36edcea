#include "agents/perception/plane/geometry.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "agents/perception/lens.hpp"
#include "agents/perception/overlap.hpp"
#include "tests/support/flat_floor.hpp"
#include "tests/support/under_ceiling.hpp"

namespace weft::agents {
namespace {

/// Returns the place on the ceiling, from the camera, that the image's centre shows.
Eigen::Vector2d centroid(const CameraModel& camera, const Attitude& attitude) {
  const Eigen::Vector2d eye = (level_from_body(attitude) * camera.robot_from_camera).translation.head<2>();
  const Eigen::Vector2d centre((camera.width - 1) / 2.0, (camera.height - 1) / 2.0);
  return apply(camera_from_plane(camera, attitude, test::ceiling_m).inverse(),
               normalised_from_pixel(camera, centre)) -
         eye;
}

TEST(PlaneGeometry, AtNoHeightIsTheFloor) {
  const CameraModel camera = test::paper_camera();
  const Attitude attitude{0.01, -0.02, 0.003};
  EXPECT_EQ(camera_from_plane(camera, attitude, 0.0), camera_from_floor(camera, attitude));
  EXPECT_LT(
      (apply(camera_from_floor(camera, attitude), {0.9, 0.2}) - test::projected(camera, attitude, {0.9, 0.2, 0.0}))
          .norm(),
      1e-12);
}

TEST(PlaneGeometry, TheImagesCentreIsAboveTheCameraOnlyStraightUp) {
  EXPECT_LT(centroid(test::upward_camera(), {}).norm(), 1e-12);
  const Eigen::Vector2d of_mount = centroid(test::upward_camera(2.0 * test::degree), {});
  EXPECT_NEAR(of_mount.x(), 6.4 * std::tan(2.0 * test::degree), 1e-9);
  EXPECT_NEAR(of_mount.x(), 0.22, 0.005);
  EXPECT_NEAR(of_mount.y(), 0.0, 1e-9);
  EXPECT_NEAR(centroid(test::upward_camera(), {0.0, 2.0 * test::degree, 0.0}).y(), -0.22, 0.005);
}

TEST(PlaneGeometry, ThePointAboveTheRobotIsRightThroughMountAndAttitude) {
  const CameraModel camera = test::upward_camera(2.0 * test::degree, -1.0 * test::degree);
  const Attitude attitude{0.012, -0.02, 0.004};
  const Eigen::Vector2d above = apply(camera_from_plane(camera, attitude, test::ceiling_m), {0.0, 0.0});
  EXPECT_LT((above - test::projected(camera, attitude, {0.0, 0.0, test::ceiling_m})).norm(), 1e-12);
  EXPECT_GT((above - Eigen::Vector2d::Zero()).norm() * 6.4, 0.1) << "the image's centre shows something else";
  EXPECT_LT(apply(camera_from_plane(camera, attitude, test::ceiling_m).inverse(), above).norm(), 1e-9);
}

TEST(PlaneGeometry, TheNormalPointsTowardsThePlaneEitherWay) {
  const CameraModel up = test::upward_camera();
  const PlaneAway ceiling = plane_away(up, {}, test::ceiling_m);
  EXPECT_LT((ceiling.normal_in_camera - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(ceiling.distance_m, 6.4, 1e-12);
  const PlaneAway floor = plane_away(up, {}, 0.0);
  EXPECT_LT((floor.normal_in_camera + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(floor.distance_m, 0.4, 1e-12);
  EXPECT_GT(plane_away(test::paper_camera(), {}, 0.0).normal_in_camera.z(), 0.5);
}

TEST(PlaneFootprint, OfACeilingLiesAllRoundTheCamera) {
  const CameraModel camera = test::upward_camera();
  const Eigen::Vector2d eye = camera.robot_from_camera.translation.head<2>();
  const Polygon whole = footprint(camera, {}, 20.0, test::ceiling_m);
  // The image's rows run along the robot's x, its columns along y.
  EXPECT_NEAR(area(whole), 4.0 * (6.4 * 319.5 / 240.0) * (6.4 * 239.5 / 240.0), 1e-6);
  for (const Eigen::Vector2d& corner : whole) {
    EXPECT_NEAR(std::abs(corner.x() - eye.x()), 6.4 * 239.5 / 240.0, 1e-9);
    EXPECT_NEAR(std::abs(corner.y() - eye.y()), 6.4 * 319.5 / 240.0, 1e-9);
  }
  EXPECT_NEAR(area(footprint(camera, {}, 3.0, test::ceiling_m)), 36.0, 1e-9);
}

TEST(PlaneFootprint, OfACeilingIsNoneForACameraThatLooksDown) {
  EXPECT_NEAR(area(footprint(test::paper_camera(), {}, 3.0, test::ceiling_m)), 0.0, 1e-9);
}

TEST(PlaneOverlap, OfACeilingIsTheShareThatStaysInView) {
  const CameraModel camera = test::upward_camera();
  const SeenPlane ceiling{footprint(camera, {}, 20.0, test::ceiling_m),
                          camera_from_plane(camera, {}, test::ceiling_m)};
  EXPECT_NEAR(share_of_b_seen_in_a(ceiling, ceiling, Pose2{}), 1.0, 1e-9);
  const double length_m = 2.0 * 6.4 * 239.5 / 240.0;
  EXPECT_NEAR(share_of_b_seen_in_a(ceiling, ceiling, Pose2{1.0, 0.0, 0.0}), 1.0 - 1.0 / length_m, 1e-9);
}

}  // namespace
}  // namespace weft::agents
