#pragma once
#include <string_view>
#include <vector>

#include "agents/methods/ceiling/ceiling.hpp"

namespace weft::agents {

/// Describes what the corners of the keyframe have shown of the newest view's motion.
struct Followed {
  std::string_view refused;              ///< low_contrast, few_tracks, not_converged; empty: the motion was found
  std::vector<Ceiling::Tracked> tracks;  ///< those that agree with the motion
  std::vector<PlanePair> pairs;          ///< one of each track, at its height
  PlanarFit fit;
};

/// Says how the corners' heights are to be taken.
struct FollowedHeights {
  HeightPrior prior;
  bool one_plane = false;  ///< as long as the mount's tilt is hardly known, which heights would take up
};

/// Follows the keyframe's corners into the newest view and finds the motion in two rounds: first with what is known
/// of their heights, then, after enough travel, with what the first motion leaves along the epipolar direction.
Followed follow_corners(const CameraModel& camera, const CeilingConfig& config, const Ceiling::Odometry& s,
                        const TrackingImage& image, const FollowedHeights& heights, const AttitudePrior& prior,
                        const PlanarState& expected);

}  // namespace weft::agents
