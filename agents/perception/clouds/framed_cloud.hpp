#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "core/geometry/pose3.hpp"

namespace weft::agents {

/// Describes how far a stereo pair's depth is off along its rays: sigma_z = z^2 sigma_d / (f b). Without a focal
/// length (a laser) it says nothing.
struct DepthNoise {
  double focal_px = 0.0;
  double baseline_m = 0.0;
  double disparity_sigma_px = 0.3;

  double sigma_m(double depth_m) const {
    return focal_px > 0.0 ? depth_m * depth_m * disparity_sigma_px / (focal_px * baseline_m) : 0.0;
  }
};

/// Refers to points in metres with what is known of how they were seen. A point that is not finite is a ray that met
/// nothing. `frames` is empty, or has for each point the index of the frame that saw it; `cameras` has where each
/// frame's camera stood, in the points' own coordinates.
struct FramedCloud {
  std::span<const Eigen::Vector3f> points;
  std::span<const std::uint16_t> frames{};
  std::span<const Eigen::Vector3f> cameras{};
  DepthNoise noise{};

  /// Returns where the camera stood that saw a point; the origin, when nobody says.
  Eigen::Vector3d camera_of(std::size_t point) const {
    if (frames.empty() || frames[point] >= cameras.size()) return Eigen::Vector3d::Zero();
    return cameras[frames[point]].cast<double>();
  }
};

}  // namespace weft::agents
