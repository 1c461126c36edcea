#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/network/part_layout.hpp"
#include "core/network/registration.hpp"
#include "core/network/site_frame.hpp"

namespace weft {

/// Tells what became of one pick.
struct PickFit {
  bool is_in_map = false;    ///< its place is there
  bool is_left_out = false;  ///< it contradicts the others
  double off_m = 0.0;        ///< how far it lies from where it was picked
};

/// Tells where the places of one part of the network lie on a floor plan. Derived from one map; never stored, and no
/// robot navigates by it. Places of parts without picks have no pose.
struct SiteSolution {
  Registration registration;
  std::string problem;        ///< why nothing lies on the plan, and what to do; empty: it does
  SiteFrame frame;            ///< its picks are those of the registration that are in the map
  std::vector<PickFit> fits;  ///< by pick of the registration
  PlacePoses layout_from_place;

  /// Returns nothing for a place that has no pose on the plan.
  std::optional<Pose2> plan_from_place(const PlaceId& place) const;
  /// Finds the place that lies nearest to the point. not_found: none lies within `most_m`; names the nearest.
  /// refused: none lies on the plan.
  Result<PlaceId> nearest(const Eigen::Vector2d& on_plan, double most_m) const;
};

/// Says for people how well the plan fits: "4 picks fit within 0.04 m; the map is 1.7 % long; dock-2 contradicts
/// ...".
std::string to_text(const SiteSolution& solution);

/// Works out where the network lies on a plan, a bounded piece at a time: lays out the part that the picks are joined
/// to, then fits the picks (fit_site_frame). Refused are picks in parts that nothing joins, a heading that
/// contradicts the positions, and three or more without a heading that lie on one line: a mirrored plan would fit as
/// well.
class SiteSolver {
 public:
  SiteSolver(NetworkView network, Registration registration);
  /// Looks at up to so many ways from place to place; returns whether there is more to do.
  bool step(std::size_t ways);
  /// Returns what was found, once nothing is left to do.
  SiteSolution take();

 private:
  void finish(const PlacePoses& root_from_place);

  std::optional<PartLayout> layout_;
  SiteSolution solution_;
};

/// Works all of it out at once.
SiteSolution solve_site(NetworkView network, Registration registration);

inline constexpr double kOnOneLine_m = 0.3;         ///< picks that lie so near to a line lie on it
inline constexpr double kHeadingContradicts = 0.5;  ///< radians

}  // namespace weft
