#pragma once
#include <cstddef>

#include "agents/perception/stereo/pair_light.hpp"
#include "agents/perception/stereo/stereo_corners.hpp"
#include "agents/perception/stereo/view_pose.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Sets how a pair's motion is seen.
struct StereoOdometryConfig {
  int corners = 250;            ///< [40, 2000] wanted of each keyframe
  int window_px = 15;           ///< odd, [7, 31]: of the tracker
  int pyramid_levels = 3;       ///< [1, 5]
  double nearest_m = 0.5;       ///< [0.05, 10] what is nearer is not looked for
  StereoCornerBounds corner{};  ///< most_px is set by nearest_m
  PoseBounds pose{};            ///< how corners say where the view is
  // When a view counts as seen
  std::size_t fewest_inliers = 20;    ///< [6, 1000]
  double fewest_inliers_share = 0.3;  ///< [0, 1] of the corners that were found again
  double least_spread = 0.06;         ///< [0, 0.3] root of the area that inliers cover, of the image's
  double most_residual_px = 1.0;      ///< [0.1, 10] RMS of the inliers', less what disparities' noise makes of it
  PairLightBounds light{};
  // When a view becomes the keyframe
  double keyframe_share = 0.6;    ///< [0.1, 0.95] fewer of the keyframe's corners are inliers
  double keyframe_rad = 0.35;     ///< [0.01, 2] turned by more
  double keyframe_nearer = 0.15;  ///< [0.01, 1] moved by more of the corners' median depth
  std::size_t patience = 5;       ///< [0, 100] views in a row that do not fit it are borne
};
/// Rejects what breaks a bound (invalid, naming it).
Result<void> check(const StereoOdometryConfig& config);

}  // namespace weft::agents
