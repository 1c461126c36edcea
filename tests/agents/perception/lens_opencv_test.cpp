// Every lens against OpenCV's own projection of the same rays.
#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>

#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

CameraModel camera_with(LensModel lens, const std::array<double, 5>& distortion,
                        const std::array<double, 3>& divisor) {
  CameraModel camera;
  camera.fx = 460.0;
  camera.fy = 455.0;
  camera.lens = lens;
  camera.distortion = distortion;
  camera.divisor = divisor;
  return camera;
}

/// Returns rays through the image and a little beyond, one metre ahead.
std::vector<cv::Point3d> rays() {
  std::vector<cv::Point3d> points;
  for (double x = -1.0; x <= 1.0; x += 0.125)
    for (double y = -0.6; y <= 0.6; y += 0.1) points.emplace_back(x, y, 1.0);
  return points;
}

std::vector<cv::Point2d> projected(const CameraModel& camera) {
  const cv::Matx33d matrix(camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0);
  const cv::Vec3d none(0.0, 0.0, 0.0);
  std::vector<cv::Point2d> pixels;
  if (camera.lens == LensModel::equidistant) {
    const std::vector<double> k(camera.distortion.begin(), camera.distortion.begin() + 4);
    cv::fisheye::projectPoints(rays(), pixels, none, none, matrix, k);
    return pixels;
  }
  std::vector<double> k(camera.distortion.begin(), camera.distortion.end());
  k.insert(k.end(), camera.divisor.begin(), camera.divisor.end());
  cv::projectPoints(rays(), none, none, matrix, k, pixels);
  return pixels;
}

TEST(Lens, PutsRaysWhereOpenCvDoes) {
  for (const CameraModel& camera :
       {camera_with(LensModel::radtan, {-0.12, 0.03, 0.0005, -0.0004, 0.0}, {}),
        camera_with(LensModel::radtan, {0.12, -0.45, 0.0004, -0.0003, 1.35}, {}),
        camera_with(LensModel::equidistant, {-0.02, 1.9, -3.1, 1.7, 0.0}, {}),
        camera_with(LensModel::rational, {0.31, 0.02, 0.0004, -0.0003, 0.01}, {0.38, 0.05, 0.02})}) {
    const std::vector<cv::Point3d> points = rays();
    const std::vector<cv::Point2d> pixels = projected(camera);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d ray(points[i].x, points[i].y);
      const Eigen::Vector2d pixel(pixels[i].x, pixels[i].y);
      EXPECT_LT((pixel_from_normalised(camera, ray) - pixel).norm(), 1e-9)
          << to_string(camera.lens) << ray.transpose();
      EXPECT_LT((normalised_from_pixel(camera, pixel) - ray).norm(), 1e-9)
          << to_string(camera.lens) << ray.transpose();
    }
  }
}

}  // namespace
}  // namespace weft::agents
