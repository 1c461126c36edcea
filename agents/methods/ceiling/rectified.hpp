#pragma once
#include "agents/methods/ceiling/config.hpp"
#include "agents/perception/birds_eye.hpp"
#include "agents/perception/lamps.hpp"

namespace weft::agents {

/// Returns how large a pixel of the rectified ceiling is: a share of its height, whatever the camera.
inline double metres_per_pixel(const CeilingConfig& config, double ceiling_m) {
  return ceiling_m / config.px_per_height;
}

/// Returns the stretch of the ceiling that is rectified, around the robot.
inline BirdsEyeArea rectified_area(const CeilingConfig& config, const CameraModel& camera, double ceiling_m) {
  // The standard deviation about a corner of noise alone is below this in 95 of 100.
  constexpr double more_than_noise = 1.25;
  const double reach_m = config.reach_heights * (ceiling_m - camera.robot_from_camera.translation.z());
  return {.far_m = reach_m,
          .half_width_m = reach_m,
          .metres_per_pixel = metres_per_pixel(config, ceiling_m),
          .near_m = -reach_m,
          .above_floor_m = ceiling_m,
          .least_contrast = more_than_noise * config.grey_noise};
}

inline LampConfig lamp_config(const CeilingConfig& config) {
  return {config.lamp_grey, config.lamp_rim_px, config.lamp_bloom_px};
}

}  // namespace weft::agents
