#include "agents/perception/lens.hpp"

#include <cmath>

namespace weft::agents {
namespace {

/// Brown's model.
Eigen::Vector2d distort(const CameraModel& camera, const Eigen::Vector2d& n) {
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  const double r2 = n.squaredNorm();
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double xy = n.x() * n.y();
  return {n.x() * radial + 2.0 * p1 * xy + p2 * (r2 + 2.0 * n.x() * n.x()),
          n.y() * radial + p1 * (r2 + 2.0 * n.y() * n.y()) + 2.0 * p2 * xy};
}

/// Kannala & Brandt 2006, eq. 6 with k1 = 1: how far from the axis a ray at this angle lands, in focal lengths; and
/// its derivative.
struct Radius {
  double value;
  double slope;
};
Radius radius_at(const CameraModel& camera, double angle) {
  const auto& [k1, k2, k3, k4, none] = camera.distortion;
  const double a2 = angle * angle;
  return {angle * (1.0 + a2 * (k1 + a2 * (k2 + a2 * (k3 + a2 * k4)))),
          1.0 + a2 * (3.0 * k1 + a2 * (5.0 * k2 + a2 * (7.0 * k3 + a2 * 9.0 * k4)))};
}

Eigen::Vector2d bend(const CameraModel& camera, const Eigen::Vector2d& n) {
  const double off_axis = n.norm();
  if (off_axis < 1e-12) return n;
  return n * (radius_at(camera, std::atan(off_axis)).value / off_axis);
}

Eigen::Vector2d unbend(const CameraModel& camera, const Eigen::Vector2d& target) {
  constexpr double widest = 1.5;  // rad; at a right angle to the axis there is no normalised point
  const double radius = target.norm();
  if (radius < 1e-12) return target;
  double angle = std::min(radius, widest);
  for (int i = 0; i < 30; ++i) {
    const Radius at = radius_at(camera, angle);
    const double step = (radius - at.value) / std::max(at.slope, 0.1);
    angle = std::clamp(angle + step, 0.0, widest);
    if (std::abs(step) < 1e-13) break;
  }
  return target * (std::tan(angle) / radius);
}

bool bounded(double value, double low, double high) {
  return std::isfinite(value) && value >= low && value <= high;
}

}  // namespace

Eigen::Vector2d pixel_from_normalised(const CameraModel& camera, const Eigen::Vector2d& normalised) {
  const Eigen::Vector2d d =
      camera.lens == LensModel::equidistant ? bend(camera, normalised) : distort(camera, normalised);
  return {camera.fx * d.x() + camera.cx, camera.fy * d.y() + camera.cy};
}

Eigen::Vector2d normalised_from_pixel(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d target((pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy);
  if (camera.lens == LensModel::equidistant) return unbend(camera, target);
  Eigen::Vector2d n = target;
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector2d error = target - distort(camera, n);
    n += error;
    if (error.squaredNorm() < 1e-22) break;
  }
  return n;
}

Result<void> check(const CameraModel& camera) {
  const auto wrong = [&](const std::string& what) {
    return fail(ErrorCode::invalid, "camera \"" + camera.id + "\": " + what + "; correct its calibration");
  };
  if (camera.width < 64 || camera.width > 8192 || camera.height < 64 || camera.height > 8192)
    return wrong("size " + std::to_string(camera.width) + "x" + std::to_string(camera.height) +
                 " is not within 64..8192 pixels");
  const double longest = std::max(camera.width, camera.height);
  for (const double focal : {camera.fx, camera.fy})
    if (!bounded(focal, 0.2 * longest, 10.0 * longest))
      return wrong("focal length " + std::to_string(focal) + " px is not within 0.2..10 image widths");
  if (!bounded(camera.cx, 0.0, camera.width) || !bounded(camera.cy, 0.0, camera.height))
    return wrong("the optical centre lies outside the image");
  for (const double k : camera.distortion)
    if (!bounded(k, -1.0, 1.0)) return wrong("distortion coefficient " + std::to_string(k) + " is not within -1..1");
  if (!is_finite(camera.robot_from_camera)) return wrong("the mount is not finite");
  if (!bounded(camera.robot_from_camera.translation.z(), 0.05, 5.0))
    return wrong("mounted " + std::to_string(camera.robot_from_camera.translation.z()) +
                 " m above the floor, not within 0.05..5 m");
  return {};
}

}  // namespace weft::agents
