#pragma once
#include <vector>

#include "server/traffic/spread.hpp"
#include "server/traffic/traffic_map.hpp"

namespace weft::server {

/// Names a place of the network as it is, and how another one lies from it.
struct Anchor {
  PlaceId place;
  Metric2 place_from_it;
};

/// Returns where a place that has been taken out of the network hangs on what is left of it: over what was taken out
/// with it, by the least uncertain ways. Empty when nothing around it is left.
std::vector<Anchor> anchors_of(const TrafficMap& map, const PlaceId& gone);

}  // namespace weft::server
