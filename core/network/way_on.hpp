#pragma once
#include <cstddef>
#include <set>
#include <string>

#include "core/network/network.hpp"

namespace weft {

/// Tells where a robot can go on to from a place that it has come to.
struct WayOn {
  bool leads_on = false;
  std::size_t places = 0;  ///< that can be driven to, when it does not lead on
};

/// Finds whether a robot of these methods that stands at `place` can drive on for as long as it likes, and back to
/// where robots come from: by strongly connected parts of what can be driven from there, and of what leads there
/// (docs/decisions/075). Looks at some thousand places at most: what leads on farther than that leads on.
WayOn way_on(const Snapshot& snapshot, const PlaceId& place, const std::set<std::string>& methods);

/// Returns the methods of all runs of the map.
std::set<std::string> methods_in(const Snapshot& snapshot);

/// Says that nothing leads on from there, and what to do, for people; empty: something does.
std::string no_way_on(const Snapshot& snapshot, const PlaceId& place, const std::set<std::string>& methods);

}  // namespace weft
