#pragma once
#include <vector>

#include "agents/perception/camera_model.hpp"

namespace weft::agents::sim {

/// Holds the ray of each pixel, normalised, without distortion; row-major. The lens is radial-tangential or
/// equidistant; of the latter rays at a right angle to the axis and beyond are somewhere far off it.
struct PixelRays {
  explicit PixelRays(const CameraModel& camera);
  std::vector<float> x, y;
};

}  // namespace weft::agents::sim
