#include "agents/bodies/sim/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/perception/camera_error.hpp"

namespace weft::agents::sim {
namespace {

/// Draws an error of RMS 1 with tails: Student's distribution with 4 degrees of freedom, scaled, without the one draw
/// in 2,000 that lies beyond 5.
double error_with_tails(Random& random) {
  constexpr double kMost = 5.0;
  for (;;) {
    const double normal = random.normal();
    double squares = 0.0;
    for (int i = 0; i < 4; ++i) {
      const double other = random.normal();
      squares += other * other;
    }
    const double error = normal / std::sqrt(0.25 * squares) / std::numbers::sqrt2;
    if (std::abs(error) <= kMost) return error;
  }
}

Eigen::Vector3d errors_with_tails(Random& random) {
  const double x = error_with_tails(random);
  const double y = error_with_tails(random);
  return {x, y, error_with_tails(random)};
}

}  // namespace

CalibrationSigma stated_sigma(const Disturbances& disturbances, double focal_px) {
  constexpr double kLeast = 1e-6;  // nothing is known exactly
  const double shift_m = disturbances.mount_error_m / std::numbers::sqrt3;
  const double turn_rad = disturbances.mount_error_rad / std::numbers::sqrt3;
  const double centre_rad = disturbances.centre_error_px / focal_px;
  CalibrationSigma sigma;
  sigma.focal_share = std::max(kLeast, disturbances.focal_error);
  sigma.centre_px = std::max(kLeast, disturbances.centre_error_px);
  sigma.distortion_px = std::max(kLeast, disturbances.distortion_error_px);
  sigma.tilt_rad = std::max(kLeast, std::hypot(turn_rad, centre_rad));
  sigma.yaw_rad = std::max(kLeast, std::hypot(turn_rad, centre_rad));
  sigma.position_m = std::max(kLeast, shift_m);
  sigma.height_m = std::max(kLeast, shift_m);
  return sigma;
}

CameraModel given_camera_from(const CameraSetup& setup, const Disturbances& disturbances, const std::string& robot,
                              std::uint64_t day) {
  CameraModel camera;
  camera.id = robot + "/floor/day" + std::to_string(day);
  camera.width = setup.width;
  camera.height = setup.height;
  camera.fx = camera.fy = setup.focal_px;
  camera.cx = setup.cx_px;
  camera.cy = setup.cy_px;
  camera.distortion = {setup.k1, setup.k2, setup.p1, setup.p2, setup.k3};
  camera.robot_from_camera = downward_mount(setup.forward_m, setup.left_m, setup.height_m, setup.pitch_rad, 0.0, 0.0);
  camera.sigma = stated_sigma(disturbances, setup.focal_px);
  return camera;
}

CameraModel given_ceiling_camera_from(const CeilingCameraSetup& setup, const Disturbances& disturbances,
                                      const std::string& robot) {
  CameraModel camera;
  camera.id = robot + "/ceiling";
  camera.width = setup.width;
  camera.height = setup.height;
  camera.fx = camera.fy = setup.focal_px;
  camera.cx = setup.cx_px;
  camera.cy = setup.cy_px;
  camera.lens = setup.lens;
  if (setup.lens == LensModel::equidistant) {
    camera.distortion = {setup.k1, setup.k2, setup.k3, setup.k4, 0.0};
  } else {
    camera.distortion = {setup.k1, setup.k2, setup.p1, setup.p2, setup.k3};
  }
  camera.robot_from_camera = upward_mount(setup, false);
  camera.sigma = stated_sigma(disturbances, setup.focal_px);
  return camera;
}

CameraModel true_camera_from(const CameraModel& given, const Disturbances& disturbances, double sinks_m,
                             Random random) {
  CameraError error;
  error.focal_share = disturbances.focal_error * error_with_tails(random);
  error.shift_m = disturbances.mount_error_m / std::numbers::sqrt3 * errors_with_tails(random);
  error.turn_rad = disturbances.mount_error_rad / std::numbers::sqrt3 * errors_with_tails(random);
  error.centre_px.x() = disturbances.centre_error_px * error_with_tails(random);
  error.centre_px.y() = disturbances.centre_error_px * error_with_tails(random);
  error.distortion_px = disturbances.distortion_error_px * error_with_tails(random);
  CameraModel camera = with_error(given, error);
  camera.robot_from_camera.translation.z() -= sinks_m;
  return camera;
}

}  // namespace weft::agents::sim
