#include "agents/perception/stereo/corner_following.hpp"

#include <numeric>

namespace weft::agents {
namespace {

/// Returns where a point of the keyframe is in the rectified left image of a view; none: outside of it.
std::optional<Eigen::Vector2d> expected_at(const StereoRig& rig, const Pose3& camera_from_keyframe,
                                           const Eigen::Vector3d& in_keyframe) {
  constexpr double nearest_m = 0.1;
  const Eigen::Vector3d in_camera = camera_from_keyframe * in_keyframe;
  if (in_camera.z() < nearest_m) return std::nullopt;
  const Eigen::Vector2d at(rig.focal_px * in_camera.x() / in_camera.z() + rig.cx,
                           rig.focal_px * in_camera.y() / in_camera.z() + rig.cy);
  if (at.x() < 0.0 || at.y() < 0.0 || at.x() > rig.width || at.y() > rig.height) return std::nullopt;
  return at;
}

}  // namespace

CornerFollowing::CornerFollowing(const StereoOdometryConfig& config, const Rectifier& rectifier,
                                 const StereoKeyframe& keyframe, const TrackingImage& left)
    : config_(config), rectifier_(rectifier), keyframe_(keyframe), left_(left), at_(keyframe.corners.size()) {}

void CornerFollowing::follow_all(const Pose3& camera_from_keyframe) {
  std::vector<std::size_t> all(at_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  follow(all, camera_from_keyframe);
}

void CornerFollowing::follow_others(const Pose3& camera_from_keyframe) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < at_.size(); ++i) {
    const auto expected = expected_at(rectifier_.rig(), camera_from_keyframe, keyframe_.corners[i].in_camera);
    if (expected && !(at_[i] && (*at_[i] - *expected).norm() < config_.pose.within_px)) others.push_back(i);
  }
  follow(others, camera_from_keyframe);
}

std::vector<SeenPoint> CornerFollowing::points() const {
  std::vector<SeenPoint> points;
  for (std::size_t i = 0; i < at_.size(); ++i) {
    const StereoCorner& corner = keyframe_.corners[i];
    if (at_[i]) points.push_back({corner.in_camera, corner.disparity_px, *at_[i], std::nullopt});
  }
  return points;
}

std::vector<StereoCorner> CornerFollowing::corners() const {
  std::vector<StereoCorner> corners;
  for (std::size_t i = 0; i < at_.size(); ++i)
    if (at_[i]) corners.push_back(keyframe_.corners[i]);
  return corners;
}

void CornerFollowing::follow(const std::vector<std::size_t>& which, const Pose3& camera_from_keyframe) {
  std::vector<Eigen::Vector2d> from;
  std::vector<Eigen::Vector2d> expected;
  for (const std::size_t i : which) {
    const StereoCorner& corner = keyframe_.corners[i];
    const auto rectified = expected_at(rectifier_.rig(), camera_from_keyframe, corner.in_camera);
    from.push_back(corner.taken);
    expected.push_back(rectified ? rectifier_.taken_left(*rectified) : corner.taken);
  }
  const std::vector<Track> tracks = track_corners(keyframe_.left, left_, from, expected);
  for (std::size_t k = 0; k < which.size(); ++k) {
    at_[which[k]].reset();
    if (tracks[k].found) at_[which[k]] = rectifier_.rectified_left(tracks[k].pixel);
  }
}

}  // namespace weft::agents
