#pragma once
#include <memory>

#include "agents/bodies/sim/simulated_camera.hpp"

namespace weft::agents::sim {

/// Returns a camera that sees as `camera` does but in the site's blackouts; `camera` itself where there are none.
std::unique_ptr<SimulatedCamera> with_blackouts(std::unique_ptr<SimulatedCamera> camera, const Site& site);

}  // namespace weft::agents::sim
