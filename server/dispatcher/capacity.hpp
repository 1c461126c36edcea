#pragma once
#include <map>
#include <vector>

#include "core/network/rule_map.hpp"

namespace weft::server {

/// Holds the places that each robot holds, of some robots.
using HeldPlaces = std::map<RobotId, std::vector<PlaceId>>;

/// Returns how far rules of kind capacity let a route be released that is released to `from`, and could be to
/// `through`, like `released_by_rules`. `others` are all robots but the one whose route it is. A robot inside
/// may go on; one that leaves and comes back is counted like any other.
ReleasedByRules released_by_capacity(const RuleMap& rules, const Route& route, std::uint32_t from,
                                     std::optional<std::uint32_t> through, const HeldPlaces& others);

}  // namespace weft::server
