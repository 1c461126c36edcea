#pragma once
#include <array>
#include <string>

#include "core/camera/camera_file.hpp"
#include "core/geometry/pose3.hpp"

namespace weft::agents {

/// Describes a pinhole camera whose lens bends rays as its model says; pixels. Camera frame: OpenCV's (x right, y
/// down, z along the axis). `robot_from_camera` is the mount; the floor is z = 0 of the robot frame.
struct CameraModel {
  std::string id;
  int width = 752;
  int height = 480;
  double fx = 460.0, fy = 460.0, cx = 375.5, cy = 239.5;
  LensModel lens = LensModel::radtan;
  std::array<double, 5> distortion{};  ///< in the model's order
  std::array<double, 3> divisor{};     ///< k4 k5 k6 of a rational lens
  Pose3 robot_from_camera;
  CalibrationSigma sigma;  ///< how well all this is known
};

/// Returns the mount of a camera at (forward_m, left_m, height_m) in the robot frame, looking ahead and down by
/// `pitch_rad` (beta in Gadd & Newman, Table I), turned by `roll_rad` about its axis and `yaw_rad` about z.
Pose3 downward_mount(double forward_m, double left_m, double height_m, double pitch_rad, double roll_rad,
                     double yaw_rad);

/// Makes a camera of what a file says; where it has no mount, of `otherwise`.
CameraModel camera_model_from(const CameraCalibration& calibration, const std::string& id, const Pose3& otherwise);
CameraCalibration calibration_from(const CameraModel& camera);

}  // namespace weft::agents
