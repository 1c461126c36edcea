#pragma once
#include <Eigen/Core>

#include "agents/methods/floor/config.hpp"
#include "agents/methods/method.hpp"
#include "agents/perception/camera_model.hpp"
#include "agents/perception/mount.hpp"

namespace weft::agents {

/// Finds the errors that a calibration puts into every step that is seen
/// (docs/decisions/060-what-a-calibration-leaves.md). To first order they grow with the motion: three rows for each
/// of its parts (ahead, aside, turning: of a metre, a metre and a radian), which are the error's x, y and heading.
class CalibrationErrors {
 public:
  /// Finds for each quantity of the calibration what one sigma of it does: the floor as a camera sees it that is off
  /// by so much, through the mount's own filter and the fit of planar motion, as odometry does.
  CalibrationErrors(const FloorConfig& config, const CameraModel& camera);

  /// Returns what a step's relation has wrong by the calibration, and by what is not yet known of the mount's tilt.
  PlanarErrors of(const Pose2& moved, const Eigen::Matrix2d& tilt_covariance) const;

 private:
  static constexpr int kMotions = 9;
  Eigen::Matrix<double, kMotions, kMotions> by_calibration_;  ///< a column for one sigma of each independent cause
  Eigen::Matrix<double, kMotions, 2> by_tilt_;                ///< pitch, roll; of a radian
};

}  // namespace weft::agents
