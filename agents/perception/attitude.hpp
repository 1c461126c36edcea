#pragma once
#include <Eigen/Core>

#include "agents/perception/camera_model.hpp"

namespace weft::agents {

/// Describes the attitude of a body against its mount's calibration: nose down by pitch, left side up by roll, raised
/// by height. Vibration, load and an error of the mount look the same. level_from_body = T(0, 0, height) Ry(pitch)
/// Rx(roll); the level frame is the planar robot frame whose z = 0 is the floor.
struct Attitude {
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
  double height_m = 0.0;

  Eigen::Vector3d vector() const { return {pitch_rad, roll_rad, height_m}; }
  static Attitude from(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
};

Pose3 level_from_body(const Attitude& attitude);

}  // namespace weft::agents
