#pragma once
#include <string>
#include <vector>

#include "core/network/apart.hpp"
#include "core/network/registration.hpp"
#include "core/network/window.hpp"

namespace weft::cli {

/// Holds the differences between two revisions of the network; each list is sorted.
struct NetworkDifference {
  Revision from, to;
  std::vector<PlaceId> places_added, places_removed;
  std::vector<PlaceId> places_anew;  ///< in both, with another content
  std::vector<EdgeId> stitches_added, stitches_removed;
  std::vector<std::string> labels_added, labels_moved, labels_removed;
  std::vector<Apart> aparts_added, aparts_removed;                     ///< windows have none: `compare_aparts`
  std::vector<std::string> rules_added, rules_changed, rules_removed;  ///< the same: `compare_rules`
  /// Names plans; the same: `compare_registrations`.
  std::vector<std::string> plans_added, plans_changed, plans_removed;
  bool empty() const;
};
NetworkDifference compare(const Window& from, const Window& to);

/// Compares lists that are sorted, as a snapshot has them.
void compare_aparts(const std::vector<Apart>& from, const std::vector<Apart>& to, NetworkDifference& found);
/// Compares rules by name.
void compare_rules(const std::vector<Rule>& from, const std::vector<Rule>& to, NetworkDifference& found);

/// Compares registrations by their plans.
void compare_registrations(const std::vector<Registration>& from, const std::vector<Registration>& to,
                           NetworkDifference& found);

/// Joins both for laying out and drawing: places and edges of either; where both have one, that of `to`.
Window united(const Window& from, const Window& to);

}  // namespace weft::cli
