#pragma once
#include <vector>

#include "agents/perception/camera_model.hpp"

namespace weft::agents::sim {

/// Normalised, without distortion, of each pixel; row-major.
struct PixelRays {
  explicit PixelRays(const CameraModel& camera);
  std::vector<float> x, y;
};

}  // namespace weft::agents::sim
