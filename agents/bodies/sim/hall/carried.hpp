#pragma once
#include <span>
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/hall/sampled_rays.hpp"

namespace weft::agents::sim {

/// Holds what of the robot itself its camera sees, for each pixel in blocks of 4 x 4; it moves with the camera, so it
/// is the same in every image. Empty: nothing.
struct Carried {
  /// Takes the quads in the robot's frame.
  Carried(const SampledRays& rays, const CameraModel& camera, std::span<const Quad> in_robot);

  std::vector<float> cover;  ///< share of the pixel that it covers
  std::vector<float> grey;   ///< that it adds under light 1
};

}  // namespace weft::agents::sim
