#include "agents/perception/lens_slope.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::agents {
namespace {

CameraModel camera_with(LensModel lens) {
  CameraModel camera;
  camera.fx = camera.fy = 190.0;
  camera.cx = 320.0;
  camera.cy = 240.0;
  camera.lens = lens;
  return camera;
}

TEST(LensSlope, IsTheAnglesOverTheTangentsOfAFisheye) {
  constexpr double off_rad = 1.2;
  const double tangent = std::tan(off_rad);
  const Eigen::Matrix2d slope =
      pixels_by_normalised(camera_with(LensModel::equidistant), Eigen::Vector2d(tangent, 0.0));
  EXPECT_NEAR(slope(0, 0), std::cos(off_rad) * std::cos(off_rad), 1e-5) << "outwards";
  EXPECT_NEAR(slope(1, 1), off_rad / tangent, 1e-5) << "around";
  EXPECT_NEAR(slope(0, 1), 0.0, 1e-6);
  EXPECT_NEAR(slope(1, 0), 0.0, 1e-6);
}

TEST(LensSlope, IsOneOfALensThatBendsNothing) {
  const Eigen::Matrix2d slope = pixels_by_normalised(camera_with(LensModel::radtan), Eigen::Vector2d(0.9, -0.4));
  EXPECT_TRUE(slope.isIdentity(1e-6)) << slope;
}

}  // namespace
}  // namespace weft::agents
