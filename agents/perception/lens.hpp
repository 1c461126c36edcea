#pragma once
#include <Eigen/Core>

#include "agents/perception/camera_model.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// invalid: a size, focal length, centre, distortion or mount that no downward camera has; names the field.
Result<void> check(const CameraModel& camera);

/// Undistorted normalised coordinates (x / z, y / z in the camera frame) of a pixel, by Newton's method; below 1e-9
/// for lenses that `check` accepts. An equidistant lens sees further than normalised coordinates reach: rays beyond
/// 1.5 rad from the axis are put there.
Eigen::Vector2d normalised_from_pixel(const CameraModel& camera, const Eigen::Vector2d& pixel);

/// The inverse: distorts and scales. Pixels, the centre of the first one at (0, 0).
Eigen::Vector2d pixel_from_normalised(const CameraModel& camera, const Eigen::Vector2d& normalised);

/// Mean focal length in pixels: turns normalised distances into pixels where no more is needed.
inline double focal_px(const CameraModel& camera) {
  return 0.5 * (camera.fx + camera.fy);
}

}  // namespace weft::agents
