#include "agents/perception/camera_model.hpp"

#include <cmath>

namespace weft::agents {

Pose3 downward_mount(double forward_m, double left_m, double height_m, double pitch_rad, double roll_rad,
                     double yaw_rad) {
  const double c = std::cos(pitch_rad);
  const double s = std::sin(pitch_rad);
  Eigen::Matrix3d robot_from_axes;
  robot_from_axes.col(0) = Eigen::Vector3d(0.0, -1.0, 0.0);  // right
  robot_from_axes.col(1) = Eigen::Vector3d(-s, 0.0, -c);     // down in the image
  robot_from_axes.col(2) = Eigen::Vector3d(c, 0.0, -s);      // along the optical axis
  const Eigen::AngleAxisd yaw(yaw_rad, Eigen::Vector3d::UnitZ());
  const Eigen::AngleAxisd roll(roll_rad, Eigen::Vector3d::UnitZ());
  Pose3 mount;
  mount.rotation = Eigen::Quaterniond(yaw * robot_from_axes * roll).normalized();
  mount.translation = {forward_m, left_m, height_m};
  return mount;
}

CameraModel camera_model_from(const CameraCalibration& calibration, const std::string& id, const Pose3& otherwise) {
  return {.id = id,
          .width = calibration.width,
          .height = calibration.height,
          .fx = calibration.fx,
          .fy = calibration.fy,
          .cx = calibration.cx,
          .cy = calibration.cy,
          .lens = calibration.lens,
          .distortion = calibration.distortion,
          .divisor = calibration.divisor,
          .robot_from_camera = calibration.body_from_camera.value_or(otherwise),
          .sigma = calibration.sigma};
}

CameraCalibration calibration_from(const CameraModel& camera) {
  return {.width = camera.width,
          .height = camera.height,
          .fx = camera.fx,
          .fy = camera.fy,
          .cx = camera.cx,
          .cy = camera.cy,
          .lens = camera.lens,
          .distortion = camera.distortion,
          .divisor = camera.divisor,
          .body_from_camera = camera.robot_from_camera,
          .sigma = camera.sigma};
}

}  // namespace weft::agents
