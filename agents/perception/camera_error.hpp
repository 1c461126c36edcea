#pragma once
#include <Eigen/Core>

#include "agents/perception/camera_model.hpp"

namespace weft::agents {

/// Describes how a camera differs from what its calibration says of it: true less given.
struct CameraError {
  double focal_share = 0.0;                             ///< true / given - 1
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();  ///< of the optical centre: right, down
  double distortion_px = 0.0;                           ///< outwards, of a ray that ends in the image's corner
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();    ///< of the mount, in the robot's frame
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();   ///< likewise, about the camera: rotation vector
};

/// Returns the ray of the image's corner that lies furthest from the optical centre, undistorted and normalised.
Eigen::Vector2d image_corner(const CameraModel& camera);

/// Returns the camera that the calibration `given` would be wrong about by `error`. The lens errs in its first
/// coefficient, k1.
CameraModel with_error(const CameraModel& given, const CameraError& error);

}  // namespace weft::agents
