#pragma once
#include <Eigen/Core>

#include "agents/perception/camera_model.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Rejects a size, focal length, centre, distortion or mount that is out of bounds (invalid, naming camera and
/// field).
Result<void> check(const CameraModel& camera);

/// Returns a pixel's undistorted normalised coordinates (x / z, y / z in the camera frame), by Newton's method; the
/// error is below 1e-9 for lenses that `check` accepts. An equidistant lens sees further than normalised coordinates
/// reach: rays beyond 1.5 rad from the axis are put there.
Eigen::Vector2d normalised_from_pixel(const CameraModel& camera, const Eigen::Vector2d& pixel);

/// Returns the pixel of a ray, the inverse: distorts and scales. The centre of the first pixel is at (0, 0).
Eigen::Vector2d pixel_from_normalised(const CameraModel& camera, const Eigen::Vector2d& normalised);

/// Returns the mean focal length in pixels, which turns normalised distances into pixels where no more is needed.
inline double focal_px(const CameraModel& camera) {
  return 0.5 * (camera.fx + camera.fy);
}

}  // namespace weft::agents
