#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/obstacle.hpp"

namespace weft::agents::sim {

/// Adds an obstacle as boxes that look like it; `who` tells one from another.
void add_obstacle(const Obstacle& obstacle, std::uint32_t who, std::vector<Quad>& quads);

}  // namespace weft::agents::sim
