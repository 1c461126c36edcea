#pragma once
#include <set>
#include <string>
#include <vector>

#include "core/network/network.hpp"

namespace weft {

/// Returns nothing for a rule that fits the map. invalid: a name that breaks the rule for names, a value out of its
/// kind's bounds, nothing named, one way or one direction without spans or with an area, corners of an area out of
/// their bounds. not_found: a span's end or the label is not in the snapshot, or no edge joins the ends of a span
/// between two runs. The plan of an area need not be registered: it may be removed at any time.
Result<void> check(const Snapshot& snapshot, const Rule& rule);

/// Tells where a rule holds on one map.
struct RuleExtent {
  std::vector<PlaceId> places;  ///< sorted; of every run that covers the floor
  /// Names neighbouring places, from and to, between which the rule forbids to drive; sorted. Rules of kind one_way
  /// have some, and those that close one direction.
  std::vector<Span> forbidden;
  std::string problem;  ///< what the rule names and the map has not; empty: nothing is missing
};
/// Finds where a rule holds; costs what the extent is large, not the map.
RuleExtent extent_of(const Snapshot& snapshot, const Rule& rule);

/// Returns the hops of every run that lead along that way or back over its floor, and those of the way itself; what
/// crosses it is none of them.
std::set<Span> hops_on_the_floor_of(const Snapshot& snapshot, const std::vector<PlaceId>& way);

/// Returns where robots stand by the rules of that kind, of those places that the map has: the place of each rule's
/// label, and the last place of each of its stretches. Lists them in order of the rules' names, each place once.
std::vector<PlaceId> spots_of(const Snapshot& snapshot, RuleKind kind);

/// Return the snapshot with the rule, in the place of one of its name, or without the one of that name; one revision
/// on.
Snapshot with_rule(const Snapshot& snapshot, const Rule& rule);
Snapshot without_rule(const Snapshot& snapshot, const std::string& name);

}  // namespace weft
