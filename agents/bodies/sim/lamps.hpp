#pragma once
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// Returns how bright each of the site's lamps is in a run, against what the site file says: within
/// `Disturbances::light_change` of 1, as `random` makes it; 0 for the nearest whole number to `Change::lamps_failed`
/// of them, drawn by `Change::seed`.
std::vector<double> lamps_now(const Site& site, Random random);

}  // namespace weft::agents::sim
