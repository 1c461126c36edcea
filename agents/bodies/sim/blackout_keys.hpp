#pragma once
#include "agents/bodies/sim/site.hpp"
#include "core/config/config.hpp"

namespace weft::agents::sim {

/// Reads [[blackout]] of a site whose robots have been read.
void add_blackouts_in(const config::Table& root, Site& site);

}  // namespace weft::agents::sim
