#pragma once
#include <memory>
#include <string>

#include "agents/bodies/sim/camera.hpp"
#include "agents/bodies/sim/sim_body.hpp"

namespace weft::agents::sim {

/// Returns disturbances that are all zero, wheels perfect.
inline Disturbances no_disturbances() {
  Disturbances d;
  d.focal_error = d.centre_error_px = d.distortion_error_px = 0.0;
  d.mount_error_m = d.mount_error_rad = d.vibration_rad = d.vibration_m = 0.0;
  d.exposure_s = d.noise_grey = d.vignetting = d.exposure_drift = d.dropped_frames = d.time_jitter_s = 0.0;
  d.wheel_scale_error = d.wheel_asymmetry = d.slip = d.light_change = d.shadow = 0.0;
  return d;
}

/// Returns an empty hall of 20 x 12 m with two robots.
inline Site empty_site() {
  Site site;
  site.name = "hall";
  site.lamps.push_back({10.0, 6.0, 6.0, 0.5});
  site.robots.push_back({"r1", {4.0, 6.0, 0.0}, 1});
  site.robots.push_back({"r2", {4.0, 3.0, 0.0}, 2});
  return site;
}

inline SimBodyConfig config_of(const Site& site, const std::string& robot = "r1", std::uint64_t seed = 1,
                               std::uint64_t day = 0) {
  SimBodyConfig config;
  config.site = site;
  config.robot = robot;
  config.seed = seed;
  config.day = day;
  return config;
}

inline std::unique_ptr<Body> body_of(const SimBodyConfig& config) {
  auto body = make_sim_body(config);
  return body ? std::move(*body) : nullptr;
}

/// Paints a white floor, with black discs of a radius at the crossings of a grid.
class DottedFloor final : public FloorSource {
 public:
  static constexpr double kSpacingM = 0.2;
  static constexpr double kRadiusM = 0.02;
  void fill(TileKey key, std::span<std::uint8_t> texels) const override {
    for (int j = 0; j < kTileTexels; ++j) {
      for (int i = 0; i < kTileTexels; ++i) {
        const double x = key.x * kTileM + (i + 0.5) * kTexelM;
        const double y = key.y * kTileM + (j + 0.5) * kTexelM;
        const double dx = x - std::round(x / kSpacingM) * kSpacingM;
        const double dy = y - std::round(y / kSpacingM) * kSpacingM;
        texels[static_cast<std::size_t>(j * kTileTexels + i)] = std::hypot(dx, dy) < kRadiusM ? 20 : 220;
      }
    }
  }
  double gloss() const override { return 0.0; }
};

}  // namespace weft::agents::sim
