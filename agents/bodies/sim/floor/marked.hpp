#pragma once
#include <memory>

#include "agents/bodies/sim/change.hpp"
#include "agents/bodies/sim/floor/source.hpp"

namespace weft::agents::sim {

/// Returns the floor with what came upon it since: painted lines, and dirt.
std::shared_ptr<const FloorSource> make_marked_floor(std::shared_ptr<const FloorSource> floor, const Change& change);

}  // namespace weft::agents::sim
