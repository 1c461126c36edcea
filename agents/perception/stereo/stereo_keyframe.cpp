#include "agents/perception/stereo/stereo_keyframe.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "agents/perception/stereo/corner_following.hpp"

namespace weft::agents {
namespace {

/// Returns the root of the area that points cover, of the image's.
double spread_of(const std::vector<SeenPoint>& points, const StereoRig& rig) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const SeenPoint& point : points) {
    const Eigen::Vector2d at(point.at_b.x() / rig.width, point.at_b.y() / rig.height);
    sum += at;
    squares += at * at.transpose();
  }
  const auto count = static_cast<double>(points.size());
  const Eigen::Vector2d mean = sum / count;
  const Eigen::Matrix2d covariance = squares / count - mean * mean.transpose();
  return std::sqrt(std::sqrt(std::max(0.0, covariance.determinant())));
}

tl::unexpected<Unseen> refuse(std::string_view reason, double measured, double bound) {
  return tl::unexpected(Unseen{reason, measured, bound});
}

}  // namespace

StereoKeyframe begin_keyframe(const StereoOdometryConfig& config, const Rectifier& rectifier,
                              const TrackingImage& left, const TrackingImage& right) {
  CornerConfig wanted;
  wanted.count = config.corners;
  wanted.border_px = config.window_px / 2 + 2;
  StereoKeyframe keyframe;
  keyframe.left = left;
  keyframe.corners = in_both(rectifier, left, right, find_corners(left, wanted), config.corner);
  keyframe.began_with = keyframe.corners.size();
  keyframe.is_newest = true;
  return keyframe;
}

OrUnseen<ComparedView> compare(const StereoOdometryConfig& config, const Rectifier& rectifier,
                               const StereoKeyframe& keyframe, const TrackingImage& left,
                               const Pose3& keyframe_from_camera) {
  constexpr double agreed_share = 0.8;  // of the corners: the others are not looked for again
  const StereoRig& rig = rectifier.rig();
  CornerFollowing following(config, rectifier, keyframe, left);
  const Pose3 expected = keyframe_from_camera.inverse();
  following.follow_all(expected);
  PoseConsensus consensus = find_pose(rig, following.points(), config.pose, expected);
  CornerFollowing again = following;
  bool is_better = false;
  if (static_cast<double>(consensus.count) < agreed_share * static_cast<double>(keyframe.corners.size())) {
    again.follow_others(consensus.b_from_a);
    const PoseConsensus second = find_pose(rig, again.points(), config.pose, consensus.b_from_a);
    is_better = second.count > consensus.count;
    if (is_better) consensus = second;
  }
  const CornerFollowing& best = is_better ? again : following;
  const std::vector<SeenPoint> points = best.points();
  const auto fewest = static_cast<double>(config.fewest_inliers);
  if (points.size() < config.fewest_inliers) return refuse("few_inliers", static_cast<double>(points.size()), fewest);
  std::optional<PoseFit> fit = fit_pose(rig, points, config.pose, consensus.b_from_a);
  const double inliers = fit ? static_cast<double>(fit->inliers) : 0.0;
  const double wanted = std::max(fewest, config.fewest_inliers_share * static_cast<double>(points.size()));
  if (inliers < wanted) return refuse("few_inliers", inliers, wanted);
  ComparedView compared{std::move(*fit), {}, {}};
  const std::vector<StereoCorner> corners = best.corners();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!compared.fit.is_inlier[i]) continue;
    compared.corners.push_back(corners[i]);
    compared.points.push_back(points[i]);
  }
  const double spread = spread_of(compared.points, rig);
  if (spread < config.least_spread) return refuse("crowded", spread, config.least_spread);
  if (compared.fit.residual_px > config.most_residual_px)
    return refuse("blurred", compared.fit.residual_px, config.most_residual_px);
  return compared;
}

PoseFit fit_with_right(const StereoOdometryConfig& config, const Rectifier& rectifier, const ComparedView& compared,
                       const TrackingImage& left, const TrackingImage& right) {
  const StereoRig& rig = rectifier.rig();
  std::vector<Eigen::Vector2d> from;
  std::vector<Eigen::Vector2d> expected;
  for (const SeenPoint& point : compared.points) {
    const double depth_m = (compared.fit.b_from_a * point.in_a).z();
    from.push_back(rectifier.taken_left(point.at_b));
    expected.push_back(rectifier.taken_right(point.at_b - Eigen::Vector2d(rig.disparity_px(depth_m), 0.0)));
  }
  const std::vector<Track> tracks = track_corners(left, right, from, expected);
  std::vector<SeenPoint> points = compared.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!tracks[i].found || tracks[i].error > config.corner.most_error_grey) continue;
    const Eigen::Vector2d at_right = rectifier.rectified_right(tracks[i].pixel);
    const double disparity = points[i].at_b.x() - at_right.x();
    if (std::abs(points[i].at_b.y() - at_right.y()) < config.corner.row_px && disparity > config.corner.least_px)
      points[i].disparity_at_b_px = disparity;
  }
  const std::optional<PoseFit> fit = fit_pose(rig, points, config.pose, compared.fit.b_from_a);
  return fit && fit->inliers >= config.fewest_inliers ? *fit : compared.fit;
}

}  // namespace weft::agents
