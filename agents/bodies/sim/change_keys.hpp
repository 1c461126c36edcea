#pragma once
#include "agents/bodies/sim/change.hpp"
#include "core/config/config.hpp"

namespace weft::agents::sim {

/// Reads [change] of a hall that high onto `preset`, whose arrays it adds to; keys that are missing leave it as it is
/// (but from_day: 0).
Change change_in(const config::Table& table, Change preset, double ceiling_m);

}  // namespace weft::agents::sim
