#pragma once
#include "agents/bodies/sim/site.hpp"
#include "core/config/config.hpp"

namespace weft::agents::sim {

/// Reads what [hall] says of the ceiling itself.
CeilingSetup ceiling_in(const config::Table& hall);

/// Reads a [[duct]] or a [[change.duct]] of a hall that high.
Duct duct_in(const config::Table& table, double ceiling_m);

/// Reads how a [[lamp]] or a [[lamp_grid]] shines: all but where it hangs.
void read_shining(const config::Table& table, Lamp& lamp);

/// Reads [[duct]], [[pipe]], [[skylight]] and [[lamp_grid]].
void add_overhead_in(const config::Table& root, Site& site);

}  // namespace weft::agents::sim
