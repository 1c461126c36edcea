#pragma once
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "server/traffic/anchors.hpp"
#include "server/traffic/layout.hpp"
#include "server/traffic/local_layouts.hpp"
#include "server/traffic/nearness.hpp"
#include "server/traffic/stretch.hpp"

namespace weft::server {

/// Holds a place that may be touched with what is known of where it lies; as short-lived as what `Nearness::around`
/// says, and `Spot`.
struct LocatedPlace {
  Touched touched;
  Nearness::Places around;
  std::vector<Spot> spots;  ///< one; several of a place that is out of the map and hangs on several parts of it
  bool is_laid = true;      ///< false: its part is not laid out yet
};

/// Holds all that somebody may touch, and in which rectangle of each part it lies.
struct LocatedPlaces {
  std::vector<LocatedPlace> places;
  std::map<std::uint32_t, Eigen::AlignedBox2d> within;
};

/// Returns how near two places may be before the robots there could touch.
double room_m(const LocatedPlace& a, const LocatedPlace& b);
/// Returns where any part of the robot may be.
Eigen::AlignedBox2d box_of(const Spot& spot, double reach_m);

/// Decides whether places are near one another: by a search of what lies around each (`Nearness`), and by where the
/// network says that both lie, however long the way from one to the other (`Layout`, and from nearby `LocalLayouts`).
/// An operator's word that two stretches are apart outweighs the layout, which is reckoned, and not the search, which
/// finds what was measured beside it.
class Proximity {
 public:
  explicit Proximity(double radius_m) : nearness_(radius_m) {}

  Layout& layout() { return layout_; }
  const Layout& layout() const { return layout_; }

  /// Returns the places around which it may look different now.
  std::vector<PlaceId> joined(const Layout::Network& network, const Batch& batch);
  void edited(const Layout::Network& network, const Snapshot& before);
  /// Forgets everything: what is remembered of the network's history has changed.
  void forget();
  /// Returns true when more may be near now than before.
  bool grow_radius(double radius_m) { return nearness_.grow_radius(radius_m); }

  LocatedPlace locate(const TrafficMap& map, const Touched& touched);
  LocatedPlaces locate(const TrafficMap& map, const std::vector<Touched>& touched);

  /// Returns whether two robots could touch: places that are no farther apart than both reaches and the margin. Two
  /// parts of the network that nothing joins know nothing of each other.
  bool overlap(const TrafficMap& map, const LocatedPlace& a, const LocatedPlace& b);
  bool overlap(const TrafficMap& map, const LocatedPlace& a, const LocatedPlaces& others);
  bool overlap(const TrafficMap& map, const std::vector<Touched>& a, const std::vector<Touched>& b);
  /// Returns the same by the layout alone.
  bool are_near_by_layout(const TrafficMap& map, const LocatedPlace& a, const LocatedPlace& b);
  /// Returns how near the two may be, by either; none: farther apart than what is searched, in different parts.
  std::optional<double> clearance_m(const LocatedPlace& a, const LocatedPlace& b) const;

  /// Returns the part in which the place is, or on which it hangs; none: that is not known yet.
  std::optional<std::uint32_t> part_of(const TrafficMap& map, const PlaceId& place);
  /// Returns how far `other` is from `place` at most, by either; none: that is not known.
  std::optional<double> farthest_m(const TrafficMap& map, const PlaceId& place, const PlaceId& other);

 private:
  const std::vector<Anchor>& anchors(const TrafficMap& map, const PlaceId& gone);

  Nearness nearness_;
  Layout layout_;
  LocalLayouts local_layouts_;
  std::map<PlaceId, std::vector<Anchor>> anchors_;  ///< of places that are out of the map, as they are asked for
};

}  // namespace weft::server
