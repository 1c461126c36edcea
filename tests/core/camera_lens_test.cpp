#include "core/camera/lens.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/camera/lens_check.hpp"

namespace weft {
namespace {

CameraCalibration camera_with(LensModel lens, const std::array<double, 5>& distortion,
                              const std::array<double, 3>& divisor = {}) {
  CameraCalibration camera;
  camera.width = 752;
  camera.height = 480;
  camera.fx = camera.fy = 460.0;
  camera.cx = 376.0;
  camera.cy = 240.0;
  camera.lens = lens;
  camera.distortion = distortion;
  camera.divisor = divisor;
  return camera;
}

std::vector<CameraCalibration> lenses() {
  return {camera_with(LensModel::radtan, {-0.28, 0.07, 0.0002, 1.8e-05, 0.0}),
          camera_with(LensModel::radtan, {0.12, -0.45, 0.0004, -0.0003, 1.35}),
          camera_with(LensModel::radtan, {0.9, 0.5, 0.01, 0.01, 0.0}),
          camera_with(LensModel::equidistant, {-0.01, 0.004, -0.003, 0.0005, 0.0}),
          camera_with(LensModel::equidistant, {-0.02, 1.9, -3.1, 1.7, 0.0}),
          camera_with(LensModel::rational, {0.31, 0.02, 0.0004, -0.0003, 0.01}, {0.38, 0.05, 0.02}),
          camera_with(LensModel::rational, {27.0, 11.0, 0.0001, -0.0002, 0.5}, {27.4, 19.0, 2.6})};
}

TEST(CameraLens, UnbendingUndoesBendingAllOverTheImage) {
  for (const CameraCalibration& camera : lenses()) {
    ASSERT_TRUE(check_lens(camera)) << check_lens(camera).error().message;
    const Lens lens{camera.lens, camera.distortion, camera.divisor};
    for (double u = 0.0; u <= 752.0; u += 47.0) {
      for (double v = 0.0; v <= 480.0; v += 30.0) {
        const Eigen::Vector2d bent((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy);
        EXPECT_LT((bend(lens, unbend(lens, bent)) - bent).norm(), 1e-10)
            << to_string(camera.lens) << " " << camera.distortion[0] << " " << u << " " << v;
      }
    }
  }
}

TEST(CameraLens, RaysBeyondTheWidestAreThere) {
  const CameraCalibration camera = camera_with(LensModel::equidistant, {});
  const Lens lens{camera.lens, camera.distortion, camera.divisor};
  EXPECT_NEAR(std::atan(unbend(lens, {2.0, 0.0}).x()), kWidestRay, 1e-12);
}

TEST(CheckLens, NamesWhereTheImageFolds) {
  // r - r^3 grows up to r = 0.577, which lands 177 px from the centre.
  const Result<void> checked = check_lens(camera_with(LensModel::radtan, {-1.0, 0.0, 0.0, 0.0, 0.0}));
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, ErrorCode::invalid);
  EXPECT_THAT(checked.error().message, testing::HasSubstr("not monotone over the image: 17"));
}

TEST(CheckLens, WhatFoldsBeyondTheImageIsNoMatter) {
  CameraCalibration camera = camera_with(LensModel::radtan, {-1.0, 0.0, 0.0, 0.0, 0.0});
  camera.fx = camera.fy = 2000.0;
  EXPECT_TRUE(check_lens(camera));
}

TEST(CheckLens, CoefficientsAreFinite) {
  CameraCalibration camera = camera_with(LensModel::rational, {}, {0.0, NAN, 0.0});
  EXPECT_THAT(check_lens(camera).error().message, testing::HasSubstr("[-1e+06, 1e+06]"));
}

}  // namespace
}  // namespace weft
