#include "agents/perception/camera_error.hpp"

#include <cmath>

#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

/// Returns how far the corner's ray moves outwards in the image, pixels, when k1 grows by one.
double corner_px_by_k1(const CameraModel& camera) {
  constexpr double step = 1e-5;
  const Eigen::Vector2d corner = image_corner(camera);
  CameraModel more = camera;
  CameraModel less = camera;
  more.distortion[0] += step;
  less.distortion[0] -= step;
  const Eigen::Vector2d moved = pixel_from_normalised(more, corner) - pixel_from_normalised(less, corner);
  return moved.norm() / (2.0 * step);
}

}  // namespace

Eigen::Vector2d image_corner(const CameraModel& camera) {
  const double right = camera.width - 1.0;
  const double down = camera.height - 1.0;
  return normalised_from_pixel(camera, {camera.cx > 0.5 * right ? 0.0 : right, camera.cy > 0.5 * down ? 0.0 : down});
}

CameraModel with_error(const CameraModel& given, const CameraError& error) {
  CameraModel camera = given;
  camera.fx *= 1.0 + error.focal_share;
  camera.fy *= 1.0 + error.focal_share;
  camera.cx += error.centre_px.x();
  camera.cy += error.centre_px.y();
  if (error.distortion_px != 0.0) camera.distortion[0] += error.distortion_px / corner_px_by_k1(given);
  camera.robot_from_camera.translation += error.shift_m;
  const double angle = error.turn_rad.norm();
  if (angle > 0.0) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, error.turn_rad / angle));
    camera.robot_from_camera.rotation = (turn * camera.robot_from_camera.rotation).normalized();
  }
  return camera;
}

}  // namespace weft::agents
