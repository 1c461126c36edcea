#include "agents/bodies/sim/pixel_rays.hpp"

#include <opencv2/calib3d.hpp>

namespace weft::agents::sim {

PixelRays::PixelRays(const CameraModel& camera) {
  std::vector<cv::Point2d> pixels;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      pixels.emplace_back(u, v);
    }
  }
  const cv::Matx33d matrix(camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0);
  std::vector<cv::Point2d> rays;
  // OpenCV's rather than the agents' own inversion: a fault in theirs must show, not cancel.
  const cv::TermCriteria precisely(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 60, 1e-9);
  if (camera.lens == LensModel::equidistant) {
    const cv::Mat distortion(1, 4, CV_64F, const_cast<double*>(camera.distortion.data()));
    cv::fisheye::undistortPoints(pixels, rays, matrix, distortion, cv::noArray(), cv::noArray(), precisely);
  } else {
    const cv::Mat distortion(1, 5, CV_64F, const_cast<double*>(camera.distortion.data()));
    cv::undistortPoints(pixels, rays, matrix, distortion, cv::noArray(), cv::noArray(), precisely);
  }
  for (const cv::Point2d& ray : rays) {
    x.push_back(static_cast<float>(ray.x));
    y.push_back(static_cast<float>(ray.y));
  }
}

}  // namespace weft::agents::sim
