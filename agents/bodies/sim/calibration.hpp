#pragma once
#include <string>

#include "agents/bodies/sim/site.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// What the agent is told.
CameraModel given_camera_from(const CameraSetup& setup, const std::string& robot, std::uint64_t day);

/// What the camera really is: focal length and mount off by the stated sizes, in directions drawn from `random`, and
/// lower by what the body has sunk.
CameraModel true_camera_from(const CameraModel& given, const Disturbances& disturbances, double sinks_m,
                             Random random);

}  // namespace weft::agents::sim
