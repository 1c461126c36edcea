#pragma once
#include <optional>

#include "agents/methods/method.hpp"
#include "core/network/difference.hpp"

namespace weft::agents {

/// Returns none when two relations between the same frames agree within both bounds (core/network/difference); else
/// "stitch_disagrees" with the measured distance, or the turn ("stitch_disagrees_in_heading"), and its bound.
std::optional<Refusal> agreement(const Relation& predicted, const Relation& measured, double within_m,
                                 double within_rad);

}  // namespace weft::agents
