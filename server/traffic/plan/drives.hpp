#pragma once
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/network/network.hpp"
#include "core/network/rule_map.hpp"
#include "core/network/search.hpp"

namespace weft::server {

/// Describes what one drives from one place to another that is a berth.
struct Drive {
  PlaceId to;
  double length_m = 0.0;
  std::vector<PlaceId> places;  ///< without the one where it begins; the last one is `to`
};

enum class Heading : std::uint8_t { onward, backward };
/// Says what a place is to a search: nothing, where one can stop and drive on, or where every way ends.
enum class Stop : std::uint8_t { none, on_the_way, end };

/// Says which edges can be driven.
struct Drivables {
  const Snapshot& network;
  const RuleMap& rules;
  const std::set<std::string>& methods;
  Passage passage;
  double farthest_m = 0.0;  ///< beyond which nothing is searched
};

/// Searches from a place along edges that can be driven, onward or backward, and no farther than to the first places
/// at which every way ends. Lengths are norms of relations, as those of routes. Returns drives in order of their
/// lengths, ties by place; a backward search, too, gives `places` from `from` on.
std::vector<Drive> drives(const Drivables& drivables, const PlaceId& from, Heading heading,
                          const std::function<Stop(const PlaceId&)>& stops);

}  // namespace weft::server
