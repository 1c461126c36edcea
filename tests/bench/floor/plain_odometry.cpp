#include "tests/bench/floor/plain_odometry.hpp"

#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/video/tracking.hpp>

namespace weft::bench {
namespace {

using namespace agents;

/// Returns how far the camera went along the floor, by the decomposition whose normal is nearest to the mount's.
double length_of(const cv::Mat& homography, const CameraModel& camera) {
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  std::vector<cv::Mat> normals;
  cv::decomposeHomographyMat(homography, cv::Mat::eye(3, 3, CV_64F), rotations, translations, normals);
  const Eigen::Vector3d down = camera.robot_from_camera.rotation.inverse() * -Eigen::Vector3d::UnitZ();
  double best = -1.0;
  double length_m = 0.0;
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const Eigen::Map<const Eigen::Vector3d> normal(normals[k].ptr<double>());
    const Eigen::Map<const Eigen::Vector3d> moved(translations[k].ptr<double>());
    if (normal.dot(down) <= best) continue;
    best = normal.dot(down);
    length_m = camera.robot_from_camera.translation.z() * moved.norm();
  }
  return length_m;
}

}  // namespace

std::optional<double> PlainOdometry::length_m(const cv::Mat& image) {
  const CameraModel& camera = views().method.camera();
  const cv::Matx33d matrix(camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0);
  const std::vector<double> lens(camera.distortion.begin(), camera.distortion.end());
  const cv::Size window(kDefaults.window_px, kDefaults.window_px);
  std::vector<cv::Mat> pyramid;
  cv::buildOpticalFlowPyramid(image, pyramid, window, kDefaults.pyramid_levels);
  std::optional<double> length_m;
  if (!last_.empty()) {
    std::vector<cv::KeyPoint> corners;
    cv::FAST(last_, corners, CornerConfig{}.threshold, true);
    cv::KeyPointsFilter::retainBest(corners, CornerConfig{}.count);
    std::vector<cv::Point2f> from;
    std::vector<cv::Point2f> to;
    cv::KeyPoint::convert(corners, from);
    std::vector<std::uint8_t> found;
    std::vector<float> error;
    cv::calcOpticalFlowPyrLK(last_pyramid_, pyramid, from, to, found, error, window, kDefaults.pyramid_levels);
    cv::undistortPoints(from, from, matrix, lens);
    cv::undistortPoints(to, to, matrix, lens);
    length_m = length_of(cv::findHomography(from, to, cv::USAC_PROSAC, 1.5 / camera.fx), camera);
  }
  last_ = image;
  last_pyramid_ = std::move(pyramid);
  return length_m;
}

}  // namespace weft::bench
