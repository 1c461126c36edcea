#pragma once
#include <Eigen/Core>

#include "core/geometry/pose3.hpp"

namespace weft::agents {

/// Describes a rectified pair: two pinholes of one focal length side by side, whose rows are the same. A point at
/// depth z lies `disparity` = focal_px baseline_m / z columns further left in the right image.
struct StereoRig {
  int width = 0;
  int height = 0;
  double focal_px = 0.0;
  double cx = 0.0, cy = 0.0;  ///< of both
  double baseline_m = 0.0;    ///< > 0
  Pose3 robot_from_camera;    ///< of the left one, as rectified: x towards the right one

  double depth_m(double disparity_px) const { return focal_px * baseline_m / disparity_px; }
  double disparity_px(double depth_m) const { return focal_px * baseline_m / depth_m; }
  /// Returns one sigma of the depth at z when the disparity's is that: z^2 sigma_d / (f b).
  double depth_sigma_m(double depth_m, double disparity_sigma_px) const {
    return depth_m * depth_m * disparity_sigma_px / (focal_px * baseline_m);
  }
  /// Returns a point in the left camera's frame. `disparity_px` > 0.
  Eigen::Vector3d point_of(double column, double row, double disparity_px) const {
    const double z = depth_m(disparity_px);
    return {(column - cx) / focal_px * z, (row - cy) / focal_px * z, z};
  }
};

}  // namespace weft::agents
