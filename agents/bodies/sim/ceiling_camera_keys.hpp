#pragma once
#include "agents/bodies/sim/ceiling_camera_setup.hpp"
#include "core/config/config.hpp"

namespace weft::agents::sim {

/// Reads a [ceiling_camera] onto `preset`; keys that are missing leave it as it is.
CeilingCameraSetup ceiling_camera_in(const config::Table& table, CeilingCameraSetup preset);

/// Reads how a camera that looks around exposes itself.
void read_exposure(const config::Table& table, ExposureSetup& exposure);

}  // namespace weft::agents::sim
