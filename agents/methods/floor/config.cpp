#include "agents/methods/floor/config.hpp"

#include <array>
#include <string_view>

#include "agents/methods/settings.hpp"

namespace weft::agents {
namespace {

// One list for `check` and for the reader; the header says the same beside each setting.
constexpr auto integers = std::to_array<Setting<FloorConfig, int>>({
    {"corners", &FloorConfig::corners, 40, 1000},
    {"window_px", &FloorConfig::window_px, 7, 31},
    {"pyramid_levels", &FloorConfig::pyramid_levels, 0, 5},
    {"fewest_tracks", &FloorConfig::fewest_tracks, 12, 500},
    {"features", &FloorConfig::features, 100, 2000},
    {"fewest_features", &FloorConfig::fewest_features, 30, 1000},
    {"most_bits", &FloorConfig::most_bits, 10, 128},
    {"fewest_matches", &FloorConfig::fewest_matches, 8, 1000},
    {"hypotheses", &FloorConfig::hypotheses, 50, 20000},
    {"fewest_inliers", &FloorConfig::fewest_inliers, 12, 1000},
});
constexpr auto numbers = std::to_array<Setting<FloorConfig, double>>({
    {"fewest_tracks_share", &FloorConfig::fewest_tracks_share, 0, 1},
    {"homography_px", &FloorConfig::homography_px, 0.2, 10},
    {"track_sigma_px", &FloorConfig::track_sigma_px, 0.01, 2},
    {"grey_noise", &FloorConfig::grey_noise, 0, 30},
    {"keyframe_m", &FloorConfig::keyframe_m, 0.01, 1},
    {"keyframe_rad", &FloorConfig::keyframe_rad, 0.01, 1},
    {"keyframe_share", &FloorConfig::keyframe_share, 0.1, 0.95},
    {"vibration_tilt_rad", &FloorConfig::vibration_tilt_rad, 1e-6, 0.05},
    {"vibration_height_m", &FloorConfig::vibration_height_m, 1e-6, 0.05},
    {"load_m", &FloorConfig::load_m, 1e-6, 0.1},
    {"focal_share", &FloorConfig::focal_share, 1e-7, 0.1},
    {"centre_px", &FloorConfig::centre_px, 1e-7, 50.0},
    {"distortion_px", &FloorConfig::distortion_px, 1e-7, 50.0},
    {"mount_tilt_rad", &FloorConfig::mount_tilt_rad, 1e-6, 0.1},
    {"mount_yaw_rad", &FloorConfig::mount_yaw_rad, 1e-6, 0.1},
    {"mount_position_m", &FloorConfig::mount_position_m, 1e-6, 0.1},
    {"mount_height_m", &FloorConfig::mount_height_m, 1e-6, 0.1},
    {"measured_scale", &FloorConfig::measured_scale, 0.0, 0.1},
    {"measured_heading_rad", &FloorConfig::measured_heading_rad, 0.0, 0.1},
    {"normal_angle_rad", &FloorConfig::normal_angle_rad, 1e-6, 1.2},
    {"along_normal_heights", &FloorConfig::along_normal_heights, 1e-6, 1},
    {"decompose_from_heights", &FloorConfig::decompose_from_heights, 0, 1},
    {"wheels_share", &FloorConfig::wheels_share, 1e-6, 2},
    {"wheels_m", &FloorConfig::wheels_m, 1e-6, 1},
    {"wheels_rad", &FloorConfig::wheels_rad, 1e-6, 1},
    {"command_factor", &FloorConfig::command_factor, 1, 20},
    {"far_m", &FloorConfig::far_m, 0.5, 4},
    {"half_width_m", &FloorConfig::half_width_m, 0.2, 3},
    {"metres_per_pixel", &FloorConfig::metres_per_pixel, 0.001, 0.02},
    {"patch_metres_per_pixel", &FloorConfig::patch_metres_per_pixel, 0.005, 0.1},
    {"gate_m", &FloorConfig::gate_m, 0.02, 1},
    {"gate_rad", &FloorConfig::gate_rad, 0.02, 1.5},
    {"widest_gate_m", &FloorConfig::widest_gate_m, 0.02, 2},
    {"ratio", &FloorConfig::ratio, 1e-6, 1},
    {"ratio_unguided", &FloorConfig::ratio_unguided, 1e-6, 1},
    {"consensus_m", &FloorConfig::consensus_m, 1e-6, 0.2},
    {"fewest_inliers_share", &FloorConfig::fewest_inliers_share, 0, 1},
    {"least_spread", &FloorConfig::least_spread, 0, 1},
    {"feature_sigma_m", &FloorConfig::feature_sigma_m, 1e-6, 0.05},
    {"inlier_sigmas", &FloorConfig::inlier_sigmas, 1, 10},
    {"kappa", &FloorConfig::kappa, 0, 1},
    {"most_tilt_rad", &FloorConfig::most_tilt_rad, 1e-6, 0.2},
    {"most_height_offset_m", &FloorConfig::most_height_offset_m, 1e-6, 0.2},
    {"eta_px", &FloorConfig::eta_px, 0.1, 1000},
    {"most_residual", &FloorConfig::most_residual, 1e-6, 1e4},
    {"most_repeated", &FloorConfig::most_repeated, 0, 10},
});

}  // namespace

std::vector<std::string> check(const FloorConfig& config) {
  std::vector<std::string> issues;
  check_settings("floor", integers, config, issues);
  check_settings("floor", numbers, config, issues);
  check_blind("floor", config.blind, issues);
  if (config.window_px % 2 == 0) issues.emplace_back("floor.window_px is even; a window has a centre");
  if (config.patch_metres_per_pixel < config.metres_per_pixel)
    issues.emplace_back("floor.patch_metres_per_pixel is finer than floor.metres_per_pixel");
  if (config.fewest_features > config.features) issues.emplace_back("floor.fewest_features exceeds floor.features");
  return issues;
}

FloorConfig read_floor_config(const config::Table& table) {
  FloorConfig config;
  read_settings(table, integers, config);
  read_settings(table, numbers, config);
  read_blind(table, config.blind);
  if (config.window_px % 2 == 0) table.refuse("window_px", "is even; a window has a centre");
  if (config.patch_metres_per_pixel < config.metres_per_pixel)
    table.refuse("patch_metres_per_pixel", "is finer than metres_per_pixel");
  if (config.fewest_features > config.features) table.refuse("fewest_features", "exceeds features");
  return config;
}

FloorConfig informed(FloorConfig config, const CalibrationSigma& known) {
  using Known = Stated<FloorConfig>;
  constexpr double kLeastTilt = 0.0005;   // a floor that is not quite flat does as much
  constexpr double kLeastScale = 0.0008;  // odometry itself
  constexpr double kLeastHeading = 1e-6;
  constexpr std::array kStated = {
      Known{&CalibrationSigma::focal_share, &FloorConfig::focal_share, 1e-7, 0.1},
      Known{&CalibrationSigma::centre_px, &FloorConfig::centre_px, 1e-7, 50.0},
      Known{&CalibrationSigma::distortion_px, &FloorConfig::distortion_px, 1e-7, 50.0},
      Known{&CalibrationSigma::tilt_rad, &FloorConfig::mount_tilt_rad, kLeastTilt, 0.1},
      Known{&CalibrationSigma::position_m, &FloorConfig::mount_position_m, 1e-6, 0.1},
      Known{&CalibrationSigma::height_m, &FloorConfig::mount_height_m, 1e-6, 0.1},
      Known{&CalibrationSigma::scale_share, &FloorConfig::measured_scale, kLeastScale, 0.1},
      Known{&CalibrationSigma::yaw_rad, &FloorConfig::measured_heading_rad, kLeastHeading, 0.1},
  };
  return with_stated(config, known, kStated);
}

}  // namespace weft::agents
