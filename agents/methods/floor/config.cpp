#include "agents/methods/floor/config.hpp"

#include <cmath>
#include <string_view>

namespace weft::agents {
namespace {

struct Bound {
  double low;
  double high;
  bool low_included = true;
};

void require(std::string_view name, double value, const Bound& bound, std::vector<std::string>& issues) {
  const bool above = bound.low_included ? value >= bound.low : value > bound.low;
  if (std::isfinite(value) && above && value <= bound.high) return;
  issues.push_back("floor." + std::string(name) + " = " + std::to_string(value) + " is not within " +
                   (bound.low_included ? "[" : "(") + std::to_string(bound.low) + ", " + std::to_string(bound.high) +
                   "]");
}

void check_odometry(const FloorConfig& c, std::vector<std::string>& issues) {
  require("corners", c.corners, {40, 1000}, issues);
  require("window_px", c.window_px, {7, 31}, issues);
  require("pyramid_levels", c.pyramid_levels, {0, 5}, issues);
  require("fewest_tracks", c.fewest_tracks, {12, 500}, issues);
  require("fewest_tracks_share", c.fewest_tracks_share, {0, 1}, issues);
  require("homography_px", c.homography_px, {0.2, 10}, issues);
  require("track_sigma_px", c.track_sigma_px, {0.01, 2}, issues);
  require("keyframe_m", c.keyframe_m, {0.01, 1}, issues);
  require("keyframe_rad", c.keyframe_rad, {0.01, 1}, issues);
  require("keyframe_share", c.keyframe_share, {0.1, 0.95}, issues);
  require("lowest_contrast", c.lowest_contrast, {0, 50}, issues);
  require("vibration_tilt_rad", c.vibration_tilt_rad, {0, 0.05, false}, issues);
  require("vibration_height_m", c.vibration_height_m, {0, 0.05, false}, issues);
  require("mount_tilt_rad", c.mount_tilt_rad, {0, 0.1, false}, issues);
  require("mount_height_m", c.mount_height_m, {0, 0.1, false}, issues);
  require("mount_position_m", c.mount_position_m, {0, 0.1, false}, issues);
  require("scale_sigma", c.scale_sigma, {0, 0.1, false}, issues);
  require("scale_memory_m", c.scale_memory_m, {0, 100, false}, issues);
  require("normal_angle_rad", c.normal_angle_rad, {0, 1.2, false}, issues);
  require("along_normal_heights", c.along_normal_heights, {0, 1, false}, issues);
  require("decompose_from_heights", c.decompose_from_heights, {0, 1}, issues);
  require("wheels_share", c.wheels_share, {0, 2, false}, issues);
  require("wheels_m", c.wheels_m, {0, 1, false}, issues);
  require("wheels_rad", c.wheels_rad, {0, 1, false}, issues);
  require("command_factor", c.command_factor, {1, 20}, issues);
  require("blind_share", c.blind_share, {0, 1, false}, issues);
  require("blind_m", c.blind_m, {0, 0.1, false}, issues);
  require("blind_rad", c.blind_rad, {0, 0.1, false}, issues);
  if (c.window_px % 2 == 0) issues.emplace_back("floor.window_px is even; a window has a centre");
}

void check_places(const FloorConfig& c, std::vector<std::string>& issues) {
  require("features", c.features, {100, 2000}, issues);
  require("fewest_features", c.fewest_features, {30, 1000}, issues);
  require("far_m", c.far_m, {0.5, 4}, issues);
  require("half_width_m", c.half_width_m, {0.2, 3}, issues);
  require("metres_per_pixel", c.metres_per_pixel, {0.001, 0.02}, issues);
  require("patch_metres_per_pixel", c.patch_metres_per_pixel, {0.005, 0.1}, issues);
  require("gate_m", c.gate_m, {0.02, 1}, issues);
  require("gate_rad", c.gate_rad, {0.02, 1.5}, issues);
  require("widest_gate_m", c.widest_gate_m, {0.02, 2}, issues);
  require("most_bits", c.most_bits, {10, 128}, issues);
  require("ratio", c.ratio, {0, 1, false}, issues);
  require("ratio_unguided", c.ratio_unguided, {0, 1, false}, issues);
  require("fewest_matches", c.fewest_matches, {8, 1000}, issues);
  require("consensus_m", c.consensus_m, {0, 0.2, false}, issues);
  require("hypotheses", c.hypotheses, {50, 20000}, issues);
  require("fewest_inliers", c.fewest_inliers, {12, 1000}, issues);
  require("fewest_inliers_share", c.fewest_inliers_share, {0, 1}, issues);
  require("feature_sigma_m", c.feature_sigma_m, {0, 0.05, false}, issues);
  require("inlier_sigmas", c.inlier_sigmas, {1, 10}, issues);
  require("kappa", c.kappa, {0, 1}, issues);
  require("most_tilt_rad", c.most_tilt_rad, {0, 0.2, false}, issues);
  require("most_lift_m", c.most_lift_m, {0, 0.2, false}, issues);
  require("eta_px", c.eta_px, {0.1, 1000}, issues);
  require("most_residual", c.most_residual, {0, 1e4, false}, issues);
  if (c.patch_metres_per_pixel < c.metres_per_pixel)
    issues.emplace_back("floor.patch_metres_per_pixel is finer than floor.metres_per_pixel");
  if (c.fewest_features > c.features) issues.emplace_back("floor.fewest_features exceeds floor.features");
}

}  // namespace

std::vector<std::string> check(const FloorConfig& config) {
  std::vector<std::string> issues;
  check_odometry(config, issues);
  check_places(config, issues);
  return issues;
}

}  // namespace weft::agents
