#include "agents/methods/ceiling/config.hpp"

#include <array>
#include <string_view>

#include "agents/methods/settings.hpp"

namespace weft::agents {
namespace {

// One list for `check` and for the reader; the header says the same beside each setting.
constexpr auto integers = std::to_array<Setting<CeilingConfig, int>>({
    {"corners", &CeilingConfig::corners, 40, 1000},
    {"window_px", &CeilingConfig::window_px, 7, 31},
    {"pyramid_levels", &CeilingConfig::pyramid_levels, 0, 5},
    {"fewest_tracks", &CeilingConfig::fewest_tracks, 8, 500},
    {"lamp_grey", &CeilingConfig::lamp_grey, 128, 255},
    {"lamp_rim_px", &CeilingConfig::lamp_rim_px, 1, 20},
    {"lamp_bloom_px", &CeilingConfig::lamp_bloom_px, 1, 60},
    {"features", &CeilingConfig::features, 50, 300},
    {"fewest_features", &CeilingConfig::fewest_features, 12, 300},
    {"most_bits", &CeilingConfig::most_bits, 10, 128},
    {"fewest_matches", &CeilingConfig::fewest_matches, 8, 1000},
    {"hypotheses", &CeilingConfig::hypotheses, 50, 20000},
    {"fewest_inliers", &CeilingConfig::fewest_inliers, 8, 1000},
});
constexpr auto numbers = std::to_array<Setting<CeilingConfig, double>>({
    {"height_sigma_m", &CeilingConfig::height_sigma_m, 0.001, 2},
    {"wheels_scale", &CeilingConfig::wheels_scale, 0.001, 0.2},
    {"wheels_way_m", &CeilingConfig::wheels_way_m, 1, 100},
    {"fewest_tracks_share", &CeilingConfig::fewest_tracks_share, 0, 1},
    {"inlier_px", &CeilingConfig::inlier_px, 0.2, 10},
    {"track_sigma_px", &CeilingConfig::track_sigma_px, 0.01, 2},
    {"grey_noise", &CeilingConfig::grey_noise, 0, 30},
    {"off_axis_rad", &CeilingConfig::off_axis_rad, 0.3, 1.5},
    {"off_vertical_rad", &CeilingConfig::off_vertical_rad, 0.3, 1.5},
    {"keyframe_heights", &CeilingConfig::keyframe_heights, 0.01, 1},
    {"keyframe_rad", &CeilingConfig::keyframe_rad, 0.01, 1},
    {"keyframe_share", &CeilingConfig::keyframe_share, 0.1, 0.95},
    {"mid_grey", &CeilingConfig::mid_grey, 30, 220},
    {"height_from_m", &CeilingConfig::height_from_m, 0.05, 2},
    {"hangs_sigma_m", &CeilingConfig::hangs_sigma_m, 0.05, 5},
    {"flat_sigma_m", &CeilingConfig::flat_sigma_m, 0.001, 0.5},
    {"least_above_m", &CeilingConfig::least_above_m, 0.05, 5},
    {"heights_tilt_rad", &CeilingConfig::heights_tilt_rad, 1e-4, 0.1},
    {"vibration_tilt_rad", &CeilingConfig::vibration_tilt_rad, 1e-6, 0.05},
    {"vibration_height_m", &CeilingConfig::vibration_height_m, 1e-6, 0.05},
    {"focal_share", &CeilingConfig::focal_share, 1e-7, 0.1},
    {"mount_tilt_rad", &CeilingConfig::mount_tilt_rad, 1e-6, 0.2},
    {"mount_yaw_rad", &CeilingConfig::mount_yaw_rad, 1e-6, 0.1},
    {"mount_position_m", &CeilingConfig::mount_position_m, 1e-6, 0.1},
    {"wheels_share", &CeilingConfig::wheels_share, 1e-6, 2},
    {"wheels_m", &CeilingConfig::wheels_m, 1e-6, 1},
    {"wheels_rad", &CeilingConfig::wheels_rad, 1e-6, 1},
    {"command_factor", &CeilingConfig::command_factor, 1, 20},
    {"reach_heights", &CeilingConfig::reach_heights, 0.3, 3},
    {"px_per_height", &CeilingConfig::px_per_height, 50, 1000},
    {"gate_m", &CeilingConfig::gate_m, 0.02, 2},
    {"gate_rad", &CeilingConfig::gate_rad, 0.02, 1.5},
    {"widest_gate_m", &CeilingConfig::widest_gate_m, 0.02, 5},
    {"ratio", &CeilingConfig::ratio, 1e-6, 1},
    {"ratio_unguided", &CeilingConfig::ratio_unguided, 1e-6, 1},
    {"consensus_px", &CeilingConfig::consensus_px, 0.1, 50},
    {"fewest_inliers_share", &CeilingConfig::fewest_inliers_share, 0, 1},
    {"least_spread", &CeilingConfig::least_spread, 0, 1},
    {"feature_sigma_px", &CeilingConfig::feature_sigma_px, 0.05, 10},
    {"inlier_sigmas", &CeilingConfig::inlier_sigmas, 1, 10},
    {"kappa", &CeilingConfig::kappa, 0, 1},
    {"most_tilt_rad", &CeilingConfig::most_tilt_rad, 1e-6, 0.3},
    {"most_scale_sigmas", &CeilingConfig::most_scale_sigmas, 1, 10},
    {"most_residual_px", &CeilingConfig::most_residual_px, 0.1, 100},
    {"most_repeated", &CeilingConfig::most_repeated, 0, 10},
});

constexpr double kLowestCeilingM = 1.0;
constexpr double kHighestCeilingM = 40.0;
constexpr std::string_view kNoHeight = "is neither 0 (wheels are to tell) nor within [1, 40]";

bool is_height(double metres) {
  return metres == 0.0 || (metres >= kLowestCeilingM && metres <= kHighestCeilingM);
}

struct Contradiction {
  std::string_view key;
  std::string_view message;
};

/// Returns what does not go together, though each by itself is within its bounds.
std::vector<Contradiction> contradictions(const CeilingConfig& config) {
  std::vector<Contradiction> all;
  if (config.window_px % 2 == 0) all.push_back({"window_px", "is even; a window has a centre"});
  if (config.fewest_features > config.features) all.push_back({"fewest_features", "exceeds features"});
  if (config.fewest_tracks > config.corners) all.push_back({"fewest_tracks", "exceeds corners"});
  if (config.lamp_bloom_px < config.lamp_rim_px) all.push_back({"lamp_bloom_px", "is less than lamp_rim_px"});
  return all;
}

}  // namespace

std::vector<std::string> check(const CeilingConfig& config) {
  std::vector<std::string> issues;
  if (!is_height(config.height_m))
    issues.push_back("ceiling.height_m = " + std::to_string(config.height_m) + " " + std::string(kNoHeight));
  check_settings("ceiling", integers, config, issues);
  check_settings("ceiling", numbers, config, issues);
  check_blind("ceiling", config.blind, issues);
  for (const auto& [key, message] : contradictions(config))
    issues.push_back("ceiling." + std::string(key) + " " + std::string(message));
  return issues;
}

CeilingConfig read_ceiling_config(const config::Table& table) {
  CeilingConfig config;
  config.height_m = table.number("height_m", config.height_m, 0.0, kHighestCeilingM);
  if (!is_height(config.height_m)) {
    table.refuse("height_m", kNoHeight);
    config.height_m = 0.0;
  }
  config.detector = table.choice("detector", "harris", {"harris", "fast"}) == "fast" ? CornerDetector::fast
                                                                                     : CornerDetector::harris;
  read_settings(table, integers, config);
  read_settings(table, numbers, config);
  read_blind(table, config.blind);
  for (const auto& [key, message] : contradictions(config)) table.refuse(key, message);
  return config;
}

CeilingConfig informed(CeilingConfig config, const CalibrationSigma& known) {
  using Known = Stated<CeilingConfig>;
  constexpr double kLeastTilt = 0.0005;  // a floor that is not quite flat does as much
  constexpr std::array kStated = {
      Known{&CalibrationSigma::focal_share, &CeilingConfig::focal_share, 1e-7, 0.1},
      Known{&CalibrationSigma::tilt_rad, &CeilingConfig::mount_tilt_rad, kLeastTilt, 0.2},
      Known{&CalibrationSigma::position_m, &CeilingConfig::mount_position_m, 1e-6, 0.1},
      Known{&CalibrationSigma::yaw_rad, &CeilingConfig::mount_yaw_rad, 1e-6, 0.1},
  };
  return with_stated(config, known, kStated);
}

}  // namespace weft::agents
