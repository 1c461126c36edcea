#include "agents/perception/calibration/camera_fit.hpp"

#include <gmock/gmock.h>

#include "agents/perception/camera_error.hpp"
#include "agents/perception/lens.hpp"
#include "tests/support/board_view.hpp"

namespace weft::agents {
namespace {

using testing::HasSubstr;
const ChessBoard kBoard{9, 6, 0.03};

CameraModel radtan() {
  CameraModel camera;
  camera.fx = 462.0;
  camera.fy = 461.0;
  camera.cx = 380.0;
  camera.cy = 236.0;
  camera.distortion = {-0.12, 0.03, 0.0005, -0.0004, 0.0};
  return camera;
}
CameraModel fisheye() {
  CameraModel camera = radtan();
  camera.lens = LensModel::equidistant;
  camera.fx = camera.fy = 330.0;
  camera.distortion = {-0.01, 0.004, -0.003, 0.0005, 0.0};
  return camera;
}

/// Returns where a camera sees the board's points, with noise.
BoardImage seen(const CameraModel& camera, const Pose3& camera_from_board, Random& random, const std::string& name,
                double square_m = 0.03) {
  BoardImage image{name, {}};
  for (int row = 0; row < kBoard.rows; ++row)
    for (int column = 0; column < kBoard.columns; ++column) {
      const Eigen::Vector3d there = camera_from_board * Eigen::Vector3d(column * square_m, row * square_m, 0.0);
      image.sighting.on_board.emplace_back(column * kBoard.square_m, row * kBoard.square_m);
      image.sighting.pixels.push_back(pixel_from_normalised(camera, there.hnormalized()) +
                                      0.1 * Eigen::Vector2d(random.normal(), random.normal()));
    }
  return image;
}

/// Renders the board in all parts of the image, tilted to all sides by up to `tilt_rad`.
std::vector<BoardImage> taken(const CameraModel& camera, double tilt_rad, std::size_t count = 14,
                              double distance_m = 0.35) {
  const test::Print print = test::print_of(kBoard);
  Random random(5);
  std::vector<BoardImage> images;
  for (std::size_t i = 0; i < count; ++i) {
    const double around = 2.4 * static_cast<double>(i);
    const Eigen::Vector2d pixel(376.0 + 170.0 * std::cos(around), 240.0 + 90.0 * std::sin(around));
    const Pose3 pose = test::held(print, camera, pixel, distance_m, tilt_rad * std::cos(1.7 * around),
                                  tilt_rad * std::sin(1.7 * around), 0.1 * static_cast<double>(i % 5));
    images.push_back(seen(camera, pose, random, "view" + std::to_string(i) + ".png"));
  }
  return images;
}

double worst_px(const CameraModel& a, const CameraCalibration& found) {
  const CameraModel b = camera_model_from(found, "", {});
  double worst = 0.0;
  for (double u = 120.0; u < 640.0; u += 60.0)
    for (double v = 60.0; v < 420.0; v += 60.0)
      worst = std::max(worst,
                       (pixel_from_normalised(b, normalised_from_pixel(a, {u, v})) - Eigen::Vector2d(u, v)).norm());
  return worst;
}

TEST(CameraFit, FindsTheLensOfEitherModel) {
  for (const CameraModel& truth : {radtan(), fisheye()}) {
    CameraFitConfig config;
    config.lens = truth.lens;
    const auto fit =
        fit_camera(taken(truth, 0.5, 14, truth.lens == LensModel::radtan ? 0.35 : 0.26), 752, 480, config);
    ASSERT_TRUE(fit) << fit.error().message;
    EXPECT_LT(worst_px(truth, fit->camera), 1.0) << to_string(truth.lens);
    EXPECT_NEAR(fit->rms_px, 0.1 * std::sqrt(2.0), 0.02);
    ASSERT_TRUE(fit->camera.sigma.focal_share);
    EXPECT_LT(std::abs(fit->camera.fx / truth.fx - 1.0), 4.0 * *fit->camera.sigma.focal_share);
    EXPECT_LT(*fit->camera.sigma.focal_share, 0.001);
    ASSERT_TRUE(fit->camera.sigma.centre_px && fit->camera.sigma.distortion_px);
    EXPECT_LT(std::abs(fit->camera.cx - truth.cx), 4.0 * *fit->camera.sigma.centre_px);
    EXPECT_LT(std::abs(fit->camera.cy - truth.cy), 4.0 * *fit->camera.sigma.centre_px);
    EXPECT_LT(*fit->camera.sigma.centre_px, 1.0);
    CameraModel lens = truth;  // nothing but the coefficients differs
    lens.distortion = fit->camera.distortion;
    const Eigen::Vector2d corner = image_corner(truth);
    EXPECT_LT((pixel_from_normalised(lens, corner) - pixel_from_normalised(truth, corner)).norm(),
              4.0 * *fit->camera.sigma.distortion_px);
    EXPECT_FALSE(fit->camera.body_from_camera);
    for (const ImageFit& image : fit->images) {
      EXPECT_TRUE(image.used) << image.name;
      EXPECT_EQ(image.error_px.size(), 54U);
    }
  }
}

TEST(CameraFit, ANarrowLensDoesNotGetAbsurdCoefficientsFromTheWideModel) {
  CameraFitConfig config;
  config.lens = LensModel::equidistant;
  const auto fit = fit_camera(taken(radtan(), 0.5), 752, 480, config);
  ASSERT_TRUE(fit) << fit.error().message;
  for (const double coefficient : fit->camera.distortion) EXPECT_LT(std::abs(coefficient), 1.0);
  EXPECT_LT(fit->rms_px, 0.3);
}

TEST(CameraFit, FromRenderedImages) {
  const test::Print print = test::print_of(kBoard);
  CameraModel camera = radtan();
  camera.width = 480;
  camera.height = 320;
  camera.fx = camera.fy = 300.0;
  camera.cx = 238.0;
  camera.cy = 161.0;
  Random random(3);
  std::vector<BoardImage> images;
  for (int i = 0; i < 9; ++i) {
    const double around = 2.4 * i;
    const Pose3 pose = test::held(print, camera, {240.0 + 120.0 * std::cos(around), 160.0 + 80.0 * std::sin(around)},
                                  0.36, 0.5 * std::cos(1.7 * around), 0.5 * std::sin(1.7 * around), 0.05 * i);
    if (const auto found = find_board(test::view_of(print, camera, pose, random), kBoard))
      images.push_back({std::to_string(i), *found});
  }
  ASSERT_GE(images.size(), 7U);
  const auto fit = fit_camera(images, 480, 320, {});
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_LT(fit->rms_px, 0.15);
  EXPECT_NEAR(fit->camera.fx / 300.0, 1.0, 0.005);
}

TEST(CameraFit, ImagesThatDisagreeAreNamedAndLeftOut) {
  std::vector<BoardImage> images = taken(radtan(), 0.5);
  for (std::size_t i = 0; i < images[4].sighting.pixels.size(); i += 3) images[4].sighting.pixels[i].x() += 4.0;
  const auto fit = fit_camera(images, 752, 480, {});
  ASSERT_TRUE(fit) << fit.error().message;
  for (std::size_t i = 0; i < images.size(); ++i) EXPECT_EQ(fit->images[i].used, i != 4) << i;
  EXPECT_GT(fit->images[4].rms_px, 1.0);
  EXPECT_LT(fit->rms_px, 0.2);
}

std::string refusal(const Result<CameraFit>& fit) {
  return fit ? "" : fit.error().message;
}

TEST(CameraFit, DegenerateSetsAreRefusedWithTheBoundAndWhatToDo) {
  EXPECT_THAT(refusal(fit_camera(taken(radtan(), 0.5, 4), 752, 480, {})),
              testing::AllOf(HasSubstr("in 4 images"), HasSubstr("at least 6"), HasSubstr("take more")));
  EXPECT_THAT(refusal(fit_camera(taken(radtan(), 0.02), 752, 480, {})),
              testing::AnyOf(HasSubstr("nearly one pose"), HasSubstr("focal length")));
  EXPECT_THAT(refusal(fit_camera(taken(radtan(), 0.5, 14, 3.5), 752, 480, {})),
              testing::AllOf(HasSubstr("% of the image's area"), HasSubstr("nearer")));
}

TEST(CameraFit, ImagesThatContradictOneAnotherAreRefused) {
  std::vector<BoardImage> images = taken(radtan(), 0.5);
  Random random(2);
  for (BoardImage& image : images)
    for (Eigen::Vector2d& pixel : image.sighting.pixels)
      pixel += 4.0 * Eigen::Vector2d(random.normal(), random.normal());
  EXPECT_THAT(refusal(fit_camera(images, 752, 480, {})),
              testing::AnyOf(HasSubstr("contradict"), HasSubstr("reprojection error"), HasSubstr("focal length")));
}

}  // namespace
}  // namespace weft::agents
