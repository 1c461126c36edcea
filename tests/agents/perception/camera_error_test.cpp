#include "agents/perception/camera_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "agents/perception/lens.hpp"
#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

TEST(CameraErrorTest, NoneIsTheSameCamera) {
  const CameraModel given = test::paper_camera();
  const CameraModel same = with_error(given, {});
  EXPECT_EQ(same.fx, given.fx);
  EXPECT_EQ(same.distortion, given.distortion);
  EXPECT_EQ(same.robot_from_camera.rotation.coeffs(), given.robot_from_camera.rotation.coeffs());
}

TEST(CameraErrorTest, EachQuantityIsOffByWhatIsSaid) {
  const CameraModel given = test::paper_camera();
  CameraError error;
  error.focal_share = 0.01;
  error.centre_px = {2.0, -3.0};
  error.shift_m = {0.01, 0.02, 0.03};
  error.turn_rad = {0.0, 0.0, 0.04};
  const CameraModel off = with_error(given, error);
  EXPECT_NEAR(off.fy / given.fy, 1.01, 1e-12);
  EXPECT_NEAR(off.cx - given.cx, 2.0, 1e-12);
  EXPECT_NEAR(off.cy - given.cy, -3.0, 1e-12);
  EXPECT_TRUE((off.robot_from_camera.translation - given.robot_from_camera.translation).isApprox(error.shift_m));
  EXPECT_NEAR(off.robot_from_camera.rotation.angularDistance(given.robot_from_camera.rotation), 0.04, 1e-9);
}

class CameraErrorLens : public testing::TestWithParam<LensModel> {};

TEST_P(CameraErrorLens, PutsTheCornersRayAsFarOffAsIsSaid) {
  CameraModel given = test::paper_camera();
  given.lens = GetParam();
  given.distortion = {};
  const Eigen::Vector2d corner = image_corner(given);
  CameraError error;
  error.distortion_px = 0.5;
  const Eigen::Vector2d centre(given.cx, given.cy);
  const Eigen::Vector2d before = pixel_from_normalised(given, corner) - centre;
  const Eigen::Vector2d after = pixel_from_normalised(with_error(given, error), corner) - centre;
  EXPECT_NEAR(after.norm() - before.norm(), 0.5, 0.001) << "outwards";
}

INSTANTIATE_TEST_SUITE_P(Lenses, CameraErrorLens,
                         testing::Values(LensModel::radtan, LensModel::equidistant, LensModel::rational));

TEST(CameraErrorTest, TheCornerIsTheOneFurthestFromTheCentre) {
  CameraModel camera = test::paper_camera();
  camera.cx = 0.7 * camera.width;
  camera.cy = 0.3 * camera.height;
  const Eigen::Vector2d pixel = pixel_from_normalised(camera, image_corner(camera));
  EXPECT_NEAR(pixel.x(), 0.0, 1e-6);
  EXPECT_NEAR(pixel.y(), camera.height - 1.0, 1e-6);
}

}  // namespace
}  // namespace weft::agents
