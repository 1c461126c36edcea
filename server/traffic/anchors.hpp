#pragma once
#include <vector>

#include "server/traffic/ground.hpp"
#include "server/traffic/spread.hpp"

namespace weft::server {

/// A place of the network as it is, and how another one lies from it.
struct Anchor {
  PlaceId place;
  Metric2 place_from_it;
};

/// Where a place that has been taken out of the network hangs on what is left of it: over what was taken out with it,
/// by the least uncertain ways. Empty when nothing around it is left.
std::vector<Anchor> anchors_of(const Ground& ground, const PlaceId& gone);

}  // namespace weft::server
