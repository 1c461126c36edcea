#pragma once
#include <optional>

#include "agents/bodies/sim/exposure_setup.hpp"
#include "agents/perception/camera_model.hpp"

namespace weft::agents::sim {

/// Describes a square post of the robot that its camera sees, from the floor up.
struct Mast {
  double forward_m = 0.3, left_m = 0.0;
  double side_m = 0.06;
  double height_m = 1.2;
  double grey = 90.0;
};

/// Describes a camera that looks up at the ceiling. Agents are told its calibration; the true one differs by what
/// `Disturbances` say and by `tilt_error_*`.
struct CeilingCameraSetup : ExposureSetup {
  int width = 640, height = 480;
  double focal_px = 300.0;
  double cx_px = 319.5, cy_px = 239.5;
  LensModel lens = LensModel::radtan;  ///< or equidistant
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0, k4 = 0.0;
  double widest_rad = 1.2;  ///< off the axis, of an equidistant lens: its image is round
  double height_m = 0.35, forward_m = 0.0, left_m = 0.0;
  double tilt_forward_rad = 0.0, tilt_left_rad = 0.0;  ///< of the axis, from straight up; both as a rotation vector
  double yaw_rad = 0.0;                                ///< 0: the image's bottom is ahead
  double tilt_error_forward_rad = 0.0, tilt_error_left_rad = 0.0;  ///< true less given
  double bloom = 0.08;                                             ///< share of light that the lens scatters
  double fps = 10.0, fps_at_rest = 2.0;
  std::optional<Mast> mast;
};

/// Returns the mount of a camera that looks up, as agents are told it (`is_true` false) or with its tilt's error.
Pose3 upward_mount(const CeilingCameraSetup& setup, bool is_true);

}  // namespace weft::agents::sim
