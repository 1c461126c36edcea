#include "agents/perception/attitude.hpp"

#include <cmath>

#include "agents/perception/lens.hpp"
#include "agents/perception/overlap.hpp"

namespace weft::agents {

Pose3 level_from_body(const Attitude& attitude) {
  Pose3 pose;
  pose.rotation = Eigen::AngleAxisd(attitude.pitch_rad, Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(attitude.roll_rad, Eigen::Vector3d::UnitX());
  pose.translation = {0.0, 0.0, attitude.height_m};
  return pose;
}

Eigen::Matrix3d camera_from_floor(const CameraModel& camera, const Attitude& attitude) {
  const Pose3 camera_from_level = camera.robot_from_camera.inverse() * level_from_body(attitude).inverse();
  Eigen::Matrix3d homography = camera_from_level.rotation.toRotationMatrix();
  homography.col(2) = camera_from_level.translation;
  return homography;
}

FloorPlane floor_plane(const CameraModel& camera, const Attitude& attitude) {
  const Pose3 level_from_camera = level_from_body(attitude) * camera.robot_from_camera;
  return {level_from_camera.rotation.conjugate() * Eigen::Vector3d(0.0, 0.0, -1.0),
          level_from_camera.translation.z()};
}

Eigen::Vector2d apply(const Eigen::Matrix3d& homography, const Eigen::Vector2d& point) {
  return (homography * point.homogeneous()).hnormalized();
}

std::vector<Eigen::Vector2d> footprint(const CameraModel& camera, const Attitude& attitude, double far_m) {
  const Pose3 level_from_camera = level_from_body(attitude) * camera.robot_from_camera;
  const Eigen::Vector3d& eye = level_from_camera.translation;
  // Rays to the image's border; those above the horizon, or meeting the floor too far away, are cut at far_m.
  std::vector<Eigen::Vector2d> seen;
  const double w = camera.width - 1.0;
  const double h = camera.height - 1.0;
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(0, h), Eigen::Vector2d(w, h), Eigen::Vector2d(w, 0), Eigen::Vector2d(0, 0)}) {
    const Eigen::Vector3d ray = level_from_camera.rotation * normalised_from_pixel(camera, corner).homogeneous();
    const double limit = 10.0 * far_m;
    const double scale = ray.z() < 0.0 ? std::min(-eye.z() / ray.z(), limit) : limit;
    seen.emplace_back((eye + scale * ray).head<2>());
  }
  const Eigen::Vector2d axis = (level_from_camera.rotation * Eigen::Vector3d::UnitZ()).head<2>();
  const Eigen::Vector2d ahead = axis.norm() > 1e-6 ? Eigen::Vector2d(axis.normalized()) : Eigen::Vector2d::UnitX();
  return clip_half_plane(counter_clockwise(std::move(seen)), -ahead, far_m + ahead.dot(eye.head<2>()));
}

}  // namespace weft::agents
