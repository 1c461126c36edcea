#pragma once
#include "agents/bodies/sim/change.hpp"
#include "core/config/config.hpp"

namespace weft::agents::sim {

/// The keys of [change]: what is not written stays as in `preset`, and arrays add to it.
Change change_in(const config::Table& table, Change preset);

}  // namespace weft::agents::sim
