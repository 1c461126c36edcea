#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/commands.hpp"
#include "clients/cli/layout.hpp"
#include "core/network/registration.hpp"

namespace weft::cli {

/// Finds what lies within areas of rules, on the map as it was read, which is laid out on each plan once.
class RuleAreas {
 public:
  RuleAreas(Window network, std::vector<Registration> plans)
      : network_(std::move(network)), plans_(std::move(plans)) {}

  /// Returns the area with those corners on the plan of that name; no name: on the only one. Errors as
  /// `registration_of`.
  Result<Area> area_on(const std::string& plan, const Polygon& corners) const;
  /// Returns the spans of what lies within the area. not_found: its plan is not registered, or nothing lies within;
  /// refused: a plan of another file is registered under its name, or nothing lies on the plan; invalid: they are
  /// more than one rule can name.
  Result<std::vector<Span>> spans_of(const Area& area);
  /// Counts the places within the rule's area on which it does not hold. Errors of the plan as `spans_of`; 0: nothing
  /// lies within, or the rule has no area.
  Result<std::size_t> not_covered(const Rule& rule);

 private:
  Result<const Layout*> layout_on(const Area& area);

  Window network_;
  std::vector<Registration> plans_;
  std::map<std::string, Result<Layout>> layouts_;  ///< by plan
  std::optional<Snapshot> map_;                    ///< the network, once it is needed as one
};

/// Asks for the map and what is registered to it.
Result<RuleAreas> rule_areas(Session& session, const Invocation& invocation, const Output& output);

/// Names the places that spans of runs lead over, those that have left the map too.
std::set<PlaceId> places_of(const std::vector<Span>& spans);
/// Joins places that follow one another on a run to spans.
std::vector<Span> spans_of(const std::set<PlaceId>& places);

}  // namespace weft::cli
