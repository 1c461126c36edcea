#include "agents/perception/lens.hpp"

#include <cmath>

#include "core/camera/lens_check.hpp"

namespace weft::agents {
namespace {

Lens lens_of(const CameraModel& camera) {
  return {camera.lens, camera.distortion, camera.divisor};
}

bool bounded(double value, double low, double high) {
  return std::isfinite(value) && value >= low && value <= high;
}

}  // namespace

Eigen::Vector2d pixel_from_normalised(const CameraModel& camera, const Eigen::Vector2d& normalised) {
  const Eigen::Vector2d d = bend(lens_of(camera), normalised);
  return {camera.fx * d.x() + camera.cx, camera.fy * d.y() + camera.cy};
}

Eigen::Vector2d normalised_from_pixel(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  return unbend(lens_of(camera), {(pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy});
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
  if (const Result<void> sound = check_lens(calibration_from(camera)); !sound) return wrong(sound.error().message);
  if (!is_finite(camera.robot_from_camera)) return wrong("the mount is not finite");
  if (!bounded(camera.robot_from_camera.translation.z(), 0.05, 5.0))
    return wrong("mounted " + std::to_string(camera.robot_from_camera.translation.z()) +
                 " m above the floor, not within 0.05..5 m");
  return {};
}

}  // namespace weft::agents
