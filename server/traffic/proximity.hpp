#pragma once
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "server/traffic/anchors.hpp"
#include "server/traffic/layout.hpp"
#include "server/traffic/nearness.hpp"
#include "server/traffic/stretch.hpp"
#include "server/traffic/surroundings.hpp"

namespace weft::server {

/// A place that may be touched with what is known of where it lies; as short-lived as `Nearness::around` and `Spot`.
struct Looked {
  Touched touched;
  const std::vector<Near>* around = nullptr;
  std::vector<Spot> spots;  ///< one; several of a place that is out of the map and hangs on several parts of it
  bool is_laid = true;      ///< false: its part is not laid out yet
};

/// All that somebody may touch, and in which rectangle of each part it lies.
struct LookedAll {
  std::vector<Looked> places;
  std::map<std::uint32_t, Eigen::AlignedBox2d> within;
};

/// Whether places are near one another: by a search of what lies around each (`Nearness`), and by where the network
/// says that both lie, however long the way from one to the other (`Layout`, and from nearby `Surroundings`). An
/// operator's word that two stretches are apart outweighs the layout, which is reckoned, and not the search, which
/// finds what was measured beside it.
class Proximity {
 public:
  explicit Proximity(double radius_m) : nearness_(radius_m) {}

  Layout& layout() { return layout_; }
  const Layout& layout() const { return layout_; }

  void joined(const Layout::Network& network, const Batch& batch);
  void edited(const Layout::Network& network, const Snapshot& before);
  /// What is remembered of the network's past has changed.
  void forget();
  void look_at_least(double radius_m) { nearness_.look_at_least(radius_m); }

  Looked look(const Ground& ground, const Touched& touched);
  LookedAll look(const Ground& ground, const std::vector<Touched>& touched);

  /// Whether two robots could touch: places that are no farther apart than both reaches and the margin. Two parts
  /// of the network that nothing joins know nothing of each other.
  bool overlap(const Ground& ground, const Looked& a, const Looked& b);
  bool overlap(const Ground& ground, const Looked& a, const LookedAll& others);
  bool overlap(const Ground& ground, const std::vector<Touched>& a, const std::vector<Touched>& b);

  /// The part in which the place is, or on which it hangs; none: that is not known yet.
  std::optional<std::uint32_t> part_of(const Ground& ground, const PlaceId& place);
  /// How far `other` is from `place` at most, by either; none: that is not known.
  std::optional<double> farthest_m(const Ground& ground, const PlaceId& place, const PlaceId& other);

 private:
  bool are_near_by_layout(const Ground& ground, const Looked& a, const Looked& b);
  const std::vector<Anchor>& anchors(const Ground& ground, const PlaceId& gone);

  Nearness nearness_;
  Layout layout_;
  Surroundings surroundings_;
  std::map<PlaceId, std::vector<Anchor>> anchors_;  ///< of places that are out of the map, as they are asked for
};

}  // namespace weft::server
