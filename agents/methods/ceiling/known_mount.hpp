#pragma once
#include "agents/methods/ceiling/config.hpp"
#include "agents/perception/mount.hpp"

namespace weft::agents {

/// Returns what is known of a mount's tilt before a robot has driven: as it was calibrated, and mounts get knocked.
inline MountPrior mount_prior(const CeilingConfig& c) {
  MountPrior prior;
  prior.tilt_rad = 3.0 * c.mount_tilt_rad;
  prior.focal_share = c.focal_share;
  prior.vibration_tilt_rad = c.vibration_tilt_rad;
  prior.vibration_height_m = c.vibration_height_m;
  return prior;
}

}  // namespace weft::agents
