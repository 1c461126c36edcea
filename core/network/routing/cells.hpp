#pragma once
#include "core/network/routing/preparation.hpp"

/// Makes single cells. Private to the routing folder.
namespace weft::routing {

/// Returns the base cell with the same places, joined as the preparation's network has it. Both ends of an arc must
/// have their nodes. `entered` and `left` come out right too, as edges are found from either end.
BaseCell joined(const Preparation& preparation, std::uint32_t cell);
/// Returns whether joining the place anew gives what its base cell has.
bool is_joined(const Preparation& preparation, Node node);

/// Returns an overlay's entries, exits and crossings alone, without costs.
Overlay bordered(const Preparation& preparation, std::size_t level, std::uint32_t cell,
                 std::vector<std::uint32_t> children);
/// Fills in the costs of an overlay with borders.
void measure(const Preparation& preparation, std::size_t level, std::uint32_t cell, Overlay& overlay);

}  // namespace weft::routing
