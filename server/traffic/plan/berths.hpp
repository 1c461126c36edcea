#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/network/rule_map.hpp"
#include "server/traffic/plan/berth_graph.hpp"
#include "server/traffic/plan/cuts.hpp"
#include "server/traffic/plan/drives.hpp"
#include "server/traffic/proximity.hpp"

namespace weft::server {

/// Is the network with the rules on it, which live as long as what follows them.
struct RuledNetwork {
  std::shared_ptr<const Snapshot> network;
  const RuleMap* rules = nullptr;
};

/// Says what a robot can drive.
struct Drives {
  std::set<std::string> methods;
  bool keeps_limits = false;
  ClosedHops closed{};  ///< to it alone
  bool operator==(const Drives&) const = default;
};

/// Makes berths of the network: each run is cut where robots can stand one behind another, and the places at which
/// robots stand or want to stand besides are berths of their own. What can be touched is decided as for leases, by
/// `Proximity`, for robots of one size. Made as it is asked for, and remembered until the map changes.
class Berths final : public BerthGraph {
 public:
  explicit Berths(Proximity& proximity) : proximity_(proximity) {}

  /// Follows the map and the size of robots. Returns true when it has cut the map anew: the numbers of berths that
  /// were given before are then invalid.
  bool follow(const RuledNetwork& network, double footprint_m);
  /// Begins to follow them, as `follow`. What it returns true for is then to be cut, before anything else is asked.
  bool begin_to_follow(const RuledNetwork& network, double footprint_m);
  /// Cuts runs of so many places more, and the run in which that comes to an end. Returns whether all are cut.
  bool cut(std::size_t places);
  /// Has what can be touched looked up in that map, though an earlier one is followed: `Proximity` remembers what it
  /// finds for leases, too.
  void see(std::shared_ptr<const Snapshot> latest) { latest_ = std::move(latest); }
  /// Returns whether it is known where the place lies, if the network has it: berths around it can be made.
  bool is_laid(const Snapshot& network, const PlaceId& place) const {
    return network.place(place) == nullptr || proximity_.layout().spot(place).has_value();
  }
  /// Returns whether a map is followed, for robots of that size.
  bool is_for(double footprint_m) const { return network_ != nullptr && footprint_m_ == footprint_m; }
  /// Numbers a way of driving.
  std::uint32_t methods(const Drives& drives);
  /// Numbers a place; one that is no cut becomes a berth of its own. Not to be called while a plan is made.
  Berth at(const PlaceId& place);
  const PlaceId& place(Berth berth) const { return berths_[berth].located.touched.place; }
  /// Returns whether the route lies within the network, so that its places can be numbered.
  bool has(const PlaceId& place) const { return network_->place(place) != nullptr; }

  const std::vector<BerthArc>& next(Berth from, std::uint32_t methods) override;
  const std::vector<Before>& before(Berth to, std::uint32_t methods) override;
  const std::vector<Berth>& beside(Berth berth) override;
  std::size_t size() const override { return berths_.size(); }
  std::uint64_t looked_up() const override { return looked_up_; }

  bool is_cut(Berth berth) const override { return berths_[berth].is_cut; }
  bool is_cut(const PlaceId& place) const;
  /// Returns the places of an arc of `next`, without the one where it begins.
  const std::vector<PlaceId>& way(Berth from, const BerthArc& arc, std::uint32_t methods) const;

 private:
  struct Arcs {
    std::vector<BerthArc> next;
    std::vector<std::vector<PlaceId>> ways;  ///< of each, without the place where it begins
    std::vector<Before> before;
    bool has_next = false;
    bool has_before = false;
  };
  struct Known {
    LocatedPlace located;
    bool is_cut = false;
    std::optional<std::vector<Berth>> beside;
    std::deque<Arcs> arcs;  ///< by methods
  };
  using Cell = std::tuple<std::uint32_t, std::int64_t, std::int64_t>;
  struct Run {
    std::shared_ptr<const Experience> of;
    bool is_laid = false;  ///< it was known where it lies when it was cut
    std::vector<std::uint32_t> cuts;
  };

  /// Returns how near two robots may stand.
  double room_m() const { return 2.0 * (footprint_m_ + kLeastSlack_m) + kMargin_m; }
  CutRules cut_rules();
  std::size_t cut_run(const ExperienceId& id, const std::shared_ptr<const Experience>& experience);
  bool is_taken(const PlaceId& place);
  double reach_m(const PlaceId& place) const;
  LocatedPlace locate(const PlaceId& place);
  Berth number(const PlaceId& place, bool is_cut);
  Drivables ruled(Berth berth, std::uint32_t methods) const;
  bool is_beside(Berth berth, const PlaceId& cut);
  Berth middle(const PlaceId& place);
  using Cells = std::map<Cell, std::vector<PlaceId>>;
  void put_in_cell(const PlaceId& place, Cells& cells);
  void forget_around(Berth berth);
  Arcs& arcs(Berth berth, std::uint32_t methods);
  void add_touched(const LocatedPlace& here, std::set<Berth>& touched);
  template <class Visit>
  static void for_each_near(const LocatedPlace& here, const Cells& cells, Visit&& visit);

  Proximity& proximity_;
  std::shared_ptr<const Snapshot> network_;  ///< followed
  std::shared_ptr<const Snapshot> latest_;
  const RuleMap* rules_ = nullptr;
  double footprint_m_ = 0.0;
  std::uint64_t laid_moves_ = 0;
  std::uint64_t laid_ = 0;
  std::map<ExperienceId, Run> runs_;
  std::optional<ExperienceId> cut_through_;  ///< runs are cut in the order of their ids
  Cells in_cell_;                            ///< cuts, and what is a berth besides
  Cells middle_in_cell_;                     ///< middles of drives
  std::map<PlaceId, Berth> numbers_;
  std::map<PlaceId, Berth> middles_;
  std::deque<Known> berths_;
  std::vector<Drives> methods_;
  std::map<PlaceId, LocatedPlace> located_;
  std::uint64_t looked_up_ = 0;
};

}  // namespace weft::server
