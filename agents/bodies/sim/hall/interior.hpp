#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// All that stands still in a hall: floor, ceiling with beams and lamps, walls with signs, pillars, racks with stock.
/// Where the site has no wall within its bounds, the hall ends in walls of its own, one metre beyond them.
std::vector<Quad> interior_of(const Site& site);

}  // namespace weft::agents::sim
