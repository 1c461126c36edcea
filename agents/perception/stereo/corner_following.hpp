#pragma once
#include <optional>
#include <vector>

#include "agents/perception/stereo/stereo_keyframe.hpp"

namespace weft::agents {

/// Follows the corners of a keyframe into the left image of one view, some of them more than once. Refers to what it
/// is made of.
class CornerFollowing {
 public:
  CornerFollowing(const StereoOdometryConfig& config, const Rectifier& rectifier, const StereoKeyframe& keyframe,
                  const TrackingImage& left);

  /// Follows all from where the pose puts them.
  void follow_all(const Pose3& camera_from_keyframe);
  /// Follows again those that the pose does not explain, and that it puts into the image.
  void follow_others(const Pose3& camera_from_keyframe);

  /// Return those that were found, in one order.
  std::vector<SeenPoint> points() const;
  std::vector<StereoCorner> corners() const;

 private:
  void follow(const std::vector<std::size_t>& which, const Pose3& camera_from_keyframe);

  const StereoOdometryConfig& config_;
  const Rectifier& rectifier_;
  const StereoKeyframe& keyframe_;
  const TrackingImage& left_;
  std::vector<std::optional<Eigen::Vector2d>> at_;  // rectified; none: not found
};

}  // namespace weft::agents
