#pragma once
#include <vector>

#include "core/network/network.hpp"

namespace weft {

/// Returns the places where a robot at `place` may as well be said to stand: those within 0.4 m and 0.5 rad of it by
/// the shortest chain of at most four hops, whichever way these may be driven. Nearest first, ties by id; `place`
/// itself is left out. Empty when `place` is not in the snapshot.
std::vector<PlaceId> places_beside(const Snapshot& snapshot, const PlaceId& place);

}  // namespace weft
