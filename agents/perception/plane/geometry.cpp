#include "agents/perception/plane/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/perception/lens.hpp"
#include "agents/perception/overlap.hpp"

namespace weft::agents {
namespace {

/// Returns where the rays of the image's corners meet the plane; those that do not, or only far away, end early.
Polygon corners_on_plane(const CameraModel& camera, const Pose3& level_from_camera, double above_floor_m,
                         double farthest) {
  const Eigen::Vector3d& eye = level_from_camera.translation;
  const double up_m = above_floor_m - eye.z();
  const double w = camera.width - 1.0;
  const double h = camera.height - 1.0;
  Polygon seen;
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(0, h), Eigen::Vector2d(w, h), Eigen::Vector2d(w, 0), Eigen::Vector2d(0, 0)}) {
    const Eigen::Vector3d ray = level_from_camera.rotation * normalised_from_pixel(camera, corner).homogeneous();
    const bool meets = up_m < 0.0 ? ray.z() < 0.0 : ray.z() > 0.0;
    const double scale = meets ? std::min(up_m / ray.z(), farthest) : farthest;
    seen.emplace_back((eye + scale * ray).head<2>());
  }
  return counter_clockwise(std::move(seen));
}

Polygon square_about_robot(double half_m) {
  Polygon square;
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, -1), Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1)})
    square.emplace_back(half_m * corner);
  return square;
}

}  // namespace

Eigen::Matrix3d camera_from_plane(const CameraModel& camera, const Attitude& attitude, double above_floor_m) {
  const Pose3 camera_from_level = camera.robot_from_camera.inverse() * level_from_body(attitude).inverse();
  const Eigen::Matrix3d rotation = camera_from_level.rotation.toRotationMatrix();
  Eigen::Matrix3d homography = rotation;
  homography.col(2) = camera_from_level.translation + above_floor_m * rotation.col(2);
  return homography;
}

PlaneAway plane_away(const CameraModel& camera, const Attitude& attitude, double above_floor_m) {
  const Pose3 level_from_camera = level_from_body(attitude) * camera.robot_from_camera;
  const double up_m = above_floor_m - level_from_camera.translation.z();
  const Eigen::Vector3d towards(0.0, 0.0, up_m > 0.0 ? 1.0 : -1.0);
  return {level_from_camera.rotation.conjugate() * towards, std::abs(up_m)};
}

Eigen::Vector2d apply(const Eigen::Matrix3d& homography, const Eigen::Vector2d& point) {
  return (homography * point.homogeneous()).hnormalized();
}

std::vector<Eigen::Vector2d> footprint(const CameraModel& camera, const Attitude& attitude, double far_m,
                                       double above_floor_m) {
  const Pose3 level_from_camera = level_from_body(attitude) * camera.robot_from_camera;
  const Eigen::Vector2d eye = level_from_camera.translation.head<2>();
  Polygon seen = corners_on_plane(camera, level_from_camera, above_floor_m, 10.0 * far_m);
  if (above_floor_m > level_from_camera.translation.z()) return intersection(seen, square_about_robot(far_m));
  const Eigen::Vector2d axis = (level_from_camera.rotation * Eigen::Vector3d::UnitZ()).head<2>();
  const Eigen::Vector2d ahead = axis.norm() > 1e-6 ? Eigen::Vector2d(axis.normalized()) : Eigen::Vector2d::UnitX();
  return clip_half_plane(seen, -ahead, far_m + ahead.dot(eye));
}

}  // namespace weft::agents
