#pragma once
#include <Eigen/Core>
#include <vector>

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

/// Returns the homography camera_from_floor in normalised coordinates: takes (x, y, 1) on the floor, robot frame,
/// metres, to the camera frame.
Eigen::Matrix3d camera_from_floor(const CameraModel& camera, const Attitude& attitude);

/// Holds the floor's normal (from the camera towards the floor) and the camera's height above it, both as the mount
/// and the attitude say: n and d of Gadd & Newman, eq. 2.
struct FloorPlane {
  Eigen::Vector3d normal_in_camera;
  double height_m = 0.0;
};
FloorPlane floor_plane(const CameraModel& camera, const Attitude& attitude);

/// Applies a homography to a point given without its third coordinate.
Eigen::Vector2d apply(const Eigen::Matrix3d& homography, const Eigen::Vector2d& point);

/// Returns the stretch of floor that the camera sees, robot frame, counter-clockwise, cut off at `far_m` ahead of the
/// camera; empty when it sees none.
std::vector<Eigen::Vector2d> footprint(const CameraModel& camera, const Attitude& attitude, double far_m);

}  // namespace weft::agents
