#include "agents/bodies/sim/calibration.hpp"

namespace weft::agents::sim {
namespace {

Eigen::Vector3d direction_from(Random& random) {
  const Eigen::Vector3d v(random.normal(), random.normal(), random.normal());
  return v.norm() > 1e-6 ? Eigen::Vector3d(v.normalized()) : Eigen::Vector3d::UnitX();
}

}  // namespace

CameraModel given_camera_from(const CameraSetup& setup, const std::string& robot, std::uint64_t day) {
  CameraModel camera;
  camera.id = robot + "/floor/day" + std::to_string(day);
  camera.width = setup.width;
  camera.height = setup.height;
  camera.fx = camera.fy = setup.focal_px;
  camera.cx = setup.cx_px;
  camera.cy = setup.cy_px;
  camera.distortion = {setup.k1, setup.k2, setup.p1, setup.p2, setup.k3};
  camera.robot_from_camera = downward_mount(setup.forward_m, setup.left_m, setup.height_m, setup.pitch_rad, 0.0, 0.0);
  return camera;
}

CameraModel true_camera_from(const CameraModel& given, const Disturbances& disturbances, double sinks_m,
                             Random random) {
  CameraModel camera = given;
  const double focal = 1.0 + (random.chance(0.5) ? 1.0 : -1.0) * disturbances.focal_error;
  camera.fx *= focal;
  camera.fy *= focal;
  camera.robot_from_camera.translation += disturbances.mount_error_m * direction_from(random);
  const Eigen::AngleAxisd turn(disturbances.mount_error_rad, direction_from(random));
  camera.robot_from_camera.rotation = (Eigen::Quaterniond(turn) * camera.robot_from_camera.rotation).normalized();
  camera.robot_from_camera.translation.z() -= sinks_m;
  return camera;
}

}  // namespace weft::agents::sim
