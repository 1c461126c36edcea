#pragma once
#include <optional>

#include "agents/methods/method.hpp"

namespace weft::agents {

/// One sigma of a relation's planar reading.
struct Spread {
  double metres = 0.0;
  double radians = 0.0;
};
Spread spread_of(const Relation& relation);

/// None when two relations between the same frames agree within both bounds; else "stitch_disagrees" with the
/// measured distance, or the turn ("stitch_disagrees_in_heading"), and its bound.
std::optional<Refusal> agreement(const Relation& predicted, const Relation& measured, double within_m,
                                 double within_rad);

}  // namespace weft::agents
