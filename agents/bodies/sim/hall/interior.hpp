#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Returns all that stands still in a hall: floor, ceiling with beams and lamps, walls with signs, pillars, stocked
/// racks. Where the site has no wall within its bounds, the hall ends in walls of its own, one metre beyond them.
std::vector<Quad> interior_of(const Site& site);

}  // namespace weft::agents::sim
