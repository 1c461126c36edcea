#pragma once
#include <Eigen/Core>

#include "agents/methods/ceiling/config.hpp"
#include "agents/methods/method.hpp"
#include "agents/perception/camera_model.hpp"

namespace weft::agents {

/// Holds what a robot knows of the ceiling that it drives under.
struct CeilingScale {
  double ceiling_m = 0.0;  ///< above the floor
  double sigma_m = 0.0;    ///< as stated, or as wheels have told it
};

/// Sets what no drive shows of a mount's tilt, 1 sigma: what hangs on one side all along the way looks like a ceiling
/// that leans, on every drive below it alike. (Seeds 101 to 104 of the study: 0.6 to 10 mrad.)
inline constexpr double kHangingTiltRad = 0.0035;

/// Returns what a step has wrong by what all steps have in common, in metres and radians of one sigma each: the scale
/// (the ceiling's height, with it the focal length, and what hangs and is taken for the ceiling), the mount's heading
/// and place, and what is not yet known of its tilt, which puts the point above the robot aside and turns with it: 2
/// degrees at 6.4 m are 0.22 m. A tilt looks like a turn, too, half of it over a way as long as the ceiling is high.
PlanarErrors common_errors(const CeilingConfig& config, const CameraModel& camera, const CeilingScale& scale,
                           const Pose2& moved, const Eigen::Matrix2d& tilt_covariance);

}  // namespace weft::agents
