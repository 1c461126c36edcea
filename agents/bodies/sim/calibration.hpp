#pragma once
#include <string>

#include "agents/bodies/sim/site.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// Returns how well the calibrations of a site's cameras are known: the sizes of the errors that are drawn. A mount's
/// pitch, roll and yaw are known as well as the mount and the optical centre together.
CalibrationSigma stated_sigma(const Disturbances& disturbances, double focal_px);

/// Returns what the agent is told.
CameraModel given_camera_from(const CameraSetup& setup, const Disturbances& disturbances, const std::string& robot,
                              std::uint64_t day);

/// Returns what the agent is told of a camera that looks up; the same every day, as nobody measures it anew.
CameraModel given_ceiling_camera_from(const CeilingCameraSetup& setup, const Disturbances& disturbances,
                                      const std::string& robot);

/// Returns what the camera really is: focal length, optical centre, lens and mount off by errors drawn from `random`
/// whose RMS are the stated sizes, with tails, and lower by what the body has sunk.
CameraModel true_camera_from(const CameraModel& given, const Disturbances& disturbances, double sinks_m,
                             Random random);

}  // namespace weft::agents::sim
