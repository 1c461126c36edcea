#pragma once
#include <cstddef>
#include <vector>

#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/stereo/rectifier.hpp"
#include "agents/perception/stereo/stereo_corners.hpp"
#include "agents/perception/stereo/stereo_odometry_config.hpp"
#include "agents/perception/stereo/unseen.hpp"
#include "agents/perception/stereo/view_pose.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Holds a view whose corners later views are compared with, and where the newest view is from there.
struct StereoKeyframe {
  TrackingImage left;
  std::vector<StereoCorner> corners;       ///< those that did not fit a view since are gone
  std::size_t began_with = 0;              ///< corners
  Pose3 from_seen;                         ///< of the last view that was seen
  Pose3 from_camera;                       ///< of the newest view, seen or assumed
  Matrix6d covariance = Matrix6d::Zero();  ///< of from_camera, as steps since the keyframe have stated
  Duration assumed_for{};                  ///< since the last view that was seen
  bool is_newest = false;                  ///< what is assumed next leads to itself, not on from it
};

/// Begins a keyframe with the corners that both images show; both are prepared alike.
StereoKeyframe begin_keyframe(const StereoOdometryConfig& config, const Rectifier& rectifier,
                              const TrackingImage& left, const TrackingImage& right);

/// Holds how a view lies to a keyframe.
struct ComparedView {
  PoseFit fit;                        ///< a: the keyframe, b: the view
  std::vector<StereoCorner> corners;  ///< of the keyframe, which fitted
  std::vector<SeenPoint> points;      ///< the same ones, in order
};

/// Follows the keyframe's corners into a left image, from where `keyframe_from_camera` says that they are, those that
/// do not agree with the others once more from where these say. Refuses "few_inliers", "crowded" (they cover too
/// little of the image), "blurred" (they are too far off).
OrUnseen<ComparedView> compare(const StereoOdometryConfig& config, const Rectifier& rectifier,
                               const StereoKeyframe& keyframe, const TrackingImage& left,
                               const Pose3& keyframe_from_camera);

/// Fits the view once more, with the disparities that its own right image adds; as it was where they add nothing.
PoseFit fit_with_right(const StereoOdometryConfig& config, const Rectifier& rectifier, const ComparedView& compared,
                       const TrackingImage& left, const TrackingImage& right);

}  // namespace weft::agents
