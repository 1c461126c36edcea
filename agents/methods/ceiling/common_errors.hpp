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

/// Returns what a step has wrong by what all steps have in common, in metres and radians of one sigma each: the scale
/// (the ceiling's height, and with it the focal length), the mount's heading and place, and what is not yet known of
/// its tilt, which puts the point above the robot aside and turns with it: 2 degrees at 6.4 m are 0.22 m.
PlanarErrors common_errors(const CeilingConfig& config, const CameraModel& camera, const CeilingScale& scale,
                           const Pose2& moved, const Eigen::Matrix2d& tilt_covariance);

}  // namespace weft::agents
