#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Adds a rack as it is seen from an aisle: uprights, beams, boards, and on each board pallets with loads that do not
/// stand in line. What lies where is a function of the rack's name, the site's floor seed and, of the share that has
/// changed (`Change::stock`), of the change's seed and how often that has happened.
void add_rack(const Box& rack, const Site& site, std::vector<Quad>& quads);

}  // namespace weft::agents::sim
