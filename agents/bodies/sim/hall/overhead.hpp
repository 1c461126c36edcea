#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Adds what is under a hall's ceiling: beams, lamps, ducts, pipes, skylights, sprinklers and hanging signs.
void add_overhead(const Site& site, std::vector<Quad>& quads);

/// Returns whether a robot of the site looks up: what hangs then has a lower side.
bool is_seen_from_below(const Site& site);

}  // namespace weft::agents::sim
