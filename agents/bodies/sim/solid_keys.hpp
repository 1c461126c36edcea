#pragma once
#include "agents/bodies/sim/site.hpp"
#include "core/config/config.hpp"

namespace weft::agents::sim {

/// Reads [[person]], [[forklift]] and [[obstacle]].
void add_solids_in(const config::Table& root, Site& site);

}  // namespace weft::agents::sim
