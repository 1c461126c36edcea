#pragma once
#include <vector>

#include "core/network/search.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Bounds how far apart two places are that a shortcut joins, metres.
inline constexpr double longest_shortcut_m = 4.0;

/// Describes a place of a run to which the way along the network is much longer than the straight one.
struct Detour {
  PlaceId place;
  Relation kept_from_place;  ///< composed along the network
  double saves_m = 0.0;      ///< the way along it, as far as that is looked at, less the straight one
};

/// Returns the older places of its run to which a straight way from a kept place would be a shortcut, the one that
/// saves most first: at least two hops and at most longest_shortcut_m apart, and the straight less than 0.67 of the
/// way. `reached`: the places around the kept one, itself first.
std::vector<Detour> worth_cutting(const Window& map, const PlaceId& kept, const std::vector<Reached>& reached);

}  // namespace weft::agents
