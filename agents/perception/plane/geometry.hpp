#pragma once
#include <Eigen/Core>
#include <vector>

#include "agents/perception/attitude.hpp"
#include "agents/perception/camera_model.hpp"

namespace weft::agents {

/// Returns the homography camera_from_plane in normalised coordinates: takes (x, y, 1) on the level plane that lies
/// `above_floor_m` above the floor, robot frame, metres, to the camera frame. The plane may lie below the camera or
/// above it, as a ceiling; what the camera has in front of it gets a positive third coordinate.
Eigen::Matrix3d camera_from_plane(const CameraModel& camera, const Attitude& attitude, double above_floor_m);
inline Eigen::Matrix3d camera_from_floor(const CameraModel& camera, const Attitude& attitude) {
  return camera_from_plane(camera, attitude, 0.0);
}

/// Holds a plane's normal (from the camera towards the plane, which is down to a floor and up to a ceiling) and the
/// camera's distance from it, both as the mount and the attitude say: n and d of Gadd & Newman, eq. 2.
struct PlaneAway {
  Eigen::Vector3d normal_in_camera;
  double distance_m = 0.0;
};
PlaneAway plane_away(const CameraModel& camera, const Attitude& attitude, double above_floor_m);

/// Applies a homography to a point given without its third coordinate.
Eigen::Vector2d apply(const Eigen::Matrix3d& homography, const Eigen::Vector2d& point);

/// Returns the stretch of the plane that the camera sees, robot frame, counter-clockwise; empty when it sees none. A
/// plane below the camera is cut off at `far_m` ahead of it, a plane above at `far_m` on all four sides of the
/// robot.
std::vector<Eigen::Vector2d> footprint(const CameraModel& camera, const Attitude& attitude, double far_m,
                                       double above_floor_m = 0.0);

}  // namespace weft::agents
