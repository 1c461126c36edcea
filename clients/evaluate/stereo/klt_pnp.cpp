#include "clients/evaluate/stereo/klt_pnp.hpp"

#include <cmath>
#include <cstdint>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "agents/perception/opencv_view.hpp"

namespace weft::evaluate::stereo {
namespace {

constexpr int kCorners = 400;
constexpr double kQuality = 0.01;
constexpr double kApartPx = 10.0;
constexpr int kFastGrey = 20;
constexpr int kWindowPx = 21;
constexpr int kLevels = 3;
constexpr float kRowPx = 1.5F;
constexpr float kLeastPx = 1.0F;  // of disparity
constexpr int kHypotheses = 200;
constexpr float kWithinPx = 1.0F;
constexpr double kConfidence = 0.999;
constexpr std::size_t kFewest = 10;

std::vector<cv::Point2f> corners_of(const cv::Mat& image, KltCorners by) {
  std::vector<cv::Point2f> corners;
  if (by == KltCorners::shi_tomasi) {
    cv::goodFeaturesToTrack(image, corners, kCorners, kQuality, kApartPx);
    return corners;
  }
  std::vector<cv::KeyPoint> found;
  cv::FAST(image, found, kFastGrey, true);
  cv::KeyPointsFilter::retainBest(found, kCorners);
  cv::KeyPoint::convert(found, corners);
  return corners;
}

struct Followed {
  std::vector<cv::Point2f> to;
  std::vector<std::uint8_t> found;
};

Followed followed(const cv::Mat& from, const cv::Mat& to, const std::vector<cv::Point2f>& corners) {
  Followed followed;
  std::vector<float> error;
  cv::calcOpticalFlowPyrLK(from, to, corners, followed.to, followed.found, error, {kWindowPx, kWindowPx}, kLevels);
  const cv::Rect2f within(0.0F, 0.0F, static_cast<float>(to.cols), static_cast<float>(to.rows));
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (!within.contains(followed.to[i])) followed.found[i] = 0;
  return followed;
}

}  // namespace

void KltPnp::remember(const cv::Mat& left, const cv::Mat& right) {
  left_ = left.clone();
  corners_.clear();
  points_.clear();
  const std::vector<cv::Point2f> corners = corners_of(left, found_by_);
  if (corners.empty()) return;
  const Followed there = followed(left, right, corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const float disparity = corners[i].x - there.to[i].x;
    if (there.found[i] == 0 || std::abs(corners[i].y - there.to[i].y) > kRowPx || disparity < kLeastPx) continue;
    const Eigen::Vector3f point = rig_.point_of(corners[i].x, corners[i].y, disparity).cast<float>();
    corners_.push_back(corners[i]);
    points_.emplace_back(point.x(), point.y(), point.z());
  }
}

std::optional<Pose3> KltPnp::pose_in(const cv::Mat& left) const {
  if (corners_.size() < kFewest) return std::nullopt;
  const Followed now = followed(left_, left, corners_);
  std::vector<cv::Point3f> points;
  std::vector<cv::Point2f> pixels;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (now.found[i] == 0) continue;
    points.push_back(points_[i]);
    pixels.push_back(now.to[i]);
  }
  if (points.size() < kFewest) return std::nullopt;
  const cv::Matx33d camera(rig_.focal_px, 0.0, rig_.cx, 0.0, rig_.focal_px, rig_.cy, 0.0, 0.0, 1.0);
  cv::Vec3d turn;
  cv::Vec3d move;
  std::vector<int> inliers;
  if (!cv::solvePnPRansac(points, pixels, camera, cv::noArray(), turn, move, false, kHypotheses, kWithinPx,
                          kConfidence, inliers) ||
      inliers.size() < kFewest)
    return std::nullopt;
  std::vector<cv::Point3f> right_points;
  std::vector<cv::Point2f> right_pixels;
  for (const int i : inliers) {
    right_points.push_back(points[static_cast<std::size_t>(i)]);
    right_pixels.push_back(pixels[static_cast<std::size_t>(i)]);
  }
  cv::solvePnPRefineLM(right_points, right_pixels, camera, cv::noArray(), turn, move);
  Vector6d twist = Vector6d::Zero();
  twist.tail<3>() = Eigen::Vector3d(turn[0], turn[1], turn[2]);
  Pose3 current_from_previous = se3_exp(twist);
  current_from_previous.translation = {move[0], move[1], move[2]};
  if (!is_finite(current_from_previous)) return std::nullopt;
  return current_from_previous.inverse();
}

std::optional<Pose3> KltPnp::step(const agents::StereoPair& pair) {
  const cv::Mat left = agents::as_mat(pair.left);
  std::optional<Pose3> moved;
  if (!left_.empty()) moved = pose_in(left);
  remember(left, agents::as_mat(pair.right));
  return moved;
}

}  // namespace weft::evaluate::stereo
