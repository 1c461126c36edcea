#pragma once
// A ceiling 6.4 m above the camera of upward_camera, and projection without any homography.
#include <Eigen/Geometry>
#include <numbers>

#include "agents/perception/attitude.hpp"
#include "agents/perception/camera_model.hpp"

namespace weft::test {

inline constexpr double ceiling_m = 6.8;  ///< above the floor
inline constexpr double degree = std::numbers::pi / 180.0;

/// Returns a point of the level frame in the undistorted image, normalised.
inline Eigen::Vector2d projected(const agents::CameraModel& camera, const agents::Attitude& attitude,
                                 const Eigen::Vector3d& in_level) {
  const Pose3 level_from_camera = agents::level_from_body(attitude) * camera.robot_from_camera;
  return (level_from_camera.inverse() * in_level).hnormalized();
}

}  // namespace weft::test
