#pragma once
#include "agents/bodies/sim/stereo_camera_setup.hpp"
#include "core/config/config.hpp"

namespace weft::agents::sim {

/// Reads [stereo_camera]; what it does not say is as in `otherwise`.
StereoCameraSetup stereo_camera_in(const config::Table& table, StereoCameraSetup otherwise);

}  // namespace weft::agents::sim
