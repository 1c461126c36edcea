#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/network/goal.hpp"
#include "core/network/rules.hpp"
#include "core/network/search.hpp"

namespace weft {

/// Names hops, from one place to a neighbouring one, that are closed to somebody though no rule bars them.
using ClosedHops = std::set<Span>;

/// Describes who drives: rules let those leave who are inside already.
struct Passage {
  PlaceId begins;                      ///< where the robot is, or is released to
  bool keeps_limits = true;            ///< otherwise what is slowed is closed to it
  const ClosedHops* closed = nullptr;  ///< to this robot alone; null: none are
};

/// Holds what all rules of one map come to, place by place. Immutable.
class RuleMap {
 public:
  RuleMap() = default;
  /// Takes what the rules' extents take, not what the map does.
  explicit RuleMap(const Snapshot& snapshot);

  bool empty() const { return rules_.empty(); }
  /// Returns the rule that keeps a robot from driving from one place to a neighbouring one; null: none does.
  const Rule* barrier(const PlaceId& from, const PlaceId& to, const Passage& passage) const;
  /// Returns whether a rule keeps the robot from driving so, or that is closed to it.
  bool bars(const PlaceId& from, const PlaceId& to, const Passage& passage) const;
  /// Returns the rule that holds robots there; null: none does.
  const Rule* hold(const PlaceId& place) const;
  /// Returns whether there is a rule of kind capacity.
  bool counts_robots() const;
  /// Returns how many robots rules of kind capacity let in there, by the rules' names.
  std::map<std::string, std::size_t> capacities(const PlaceId& place) const;
  /// Returns whether a rule of that kind holds there.
  bool is_of(const PlaceId& place, RuleKind kind) const { return first_of(place, kind) != nullptr; }
  /// Returns the lowest limit there, metres a second; none: there is none.
  std::optional<double> limit_m_s(const PlaceId& place) const;
  /// Returns the highest class that a rule gives goals there.
  std::uint8_t priority(const PlaceId& place) const;

  bool operator==(const RuleMap&) const = default;

 private:
  using Numbers = std::vector<std::uint32_t>;  ///< of rules, ascending

  const Numbers& at(const PlaceId& place) const;
  bool is_inside(std::uint32_t rule, const PlaceId& place) const;
  const Rule* first_of(const PlaceId& place, RuleKind kind) const;

  std::vector<Rule> rules_;
  std::map<PlaceId, Numbers> places_;
  std::map<Span, Numbers> forbidden_;
  std::map<PlaceId, Numbers> enters_;  ///< by where what is forbidden leads to
  std::map<PlaceId, Numbers> leaves_;  ///< and by where it comes from
};

/// Tells how far rules let a route be released.
struct ReleasedByRules {
  std::optional<std::uint32_t> through;  ///< none: no farther than it is
  std::string rule;                      ///< the name of the one that ends it; empty: none does
};

/// Returns how far rules let a route be released that is released to `from`, and could be to `through`. The robot
/// stands on the first place, or is released to `from`.
ReleasedByRules released_by_rules(const RuleMap& rules, const Route& route, std::uint32_t from,
                                  std::optional<std::uint32_t> through, bool keeps_limits);

/// Returns the index of the first place of the route, after `from`, to which rules let nobody be released from the
/// place before; none: there is none. A hold is no such rule: it ends.
std::optional<std::uint32_t> first_barred(const RuleMap& rules, const Route& route, std::uint32_t from,
                                          bool keeps_limits);

/// Returns the speed limits of a route: as few as there can be, up to kRouteLimits, beyond which the lowest counts.
std::vector<SpeedLimit> limits_of(const RuleMap& rules, const std::vector<PlaceId>& places);

/// Finds a least-cost way like `weft::shortest_path` that no rule bars; where a limit holds, a metre costs as many
/// times more as it takes longer than at the usual speed. not_found: there is none; names the rule that bars the one
/// there would be, or what is closed of it. Takes what lies within the way's length, not what the map does.
Result<Path> shortest_path(const Snapshot& snapshot, const RuleMap& rules, const PlaceId& from, const PlaceId& to,
                           const std::set<std::string>& methods, const Passage& passage);

/// Returns whether rules make a way neither dearer nor bar it, and none of it is closed: then it is a least-cost way
/// with them, too.
bool is_free(const RuleMap& rules, const Path& path, const Passage& passage);

/// Says which rule bars the way, or what is closed of it, for people; the way is one that cannot be driven.
std::string barred_text(const RuleMap& rules, const Path& path, const Passage& passage);

}  // namespace weft
