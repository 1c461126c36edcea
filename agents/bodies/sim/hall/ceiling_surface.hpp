#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Adds the ceiling itself, of the site's kind, in place of `whole`: a level face that looks down, its `across` along
/// x and its `up` against y.
void add_ceiling(const Site& site, const Quad& whole, std::vector<Quad>& quads);

}  // namespace weft::agents::sim
