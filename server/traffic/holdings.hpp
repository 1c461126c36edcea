#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "server/traffic/proximity.hpp"

namespace weft::server {

/// Keeps what everybody holds, found by place: to ask who is near a place costs what lies around that place, however
/// many robots there are. Answers as `Proximity::overlap` does of each of them.
class Holdings {
 public:
  Holdings() = default;
  Holdings(const Holdings&) = delete;
  Holdings& operator=(const Holdings&) = delete;

  /// Replaces what the robot holds; places that stay in order cost nothing.
  void put(const TrafficMap& map, Proximity& proximity, const RobotId& robot, const std::vector<Touched>& touched);
  /// Returns the robots that hold something that overlaps with `here`, in order of their ids, without `except`.
  std::set<RobotId> near(const TrafficMap& map, Proximity& proximity, const LocatedPlace& here,
                         const RobotId& except) const;
  /// Returns whether that robot does.
  bool holds_near(const TrafficMap& map, Proximity& proximity, const RobotId& robot, const LocatedPlace& here) const;
  /// Returns how near the robot's holding may be to `here`; none: farther than anything that could overlap.
  std::optional<double> clearance_m(const Proximity& proximity, const RobotId& robot, const LocatedPlace& here) const;
  /// Returns how near it most probably is, as all is laid out; none: in different parts.
  std::optional<double> distance_m(const RobotId& robot, const LocatedPlace& here) const;
  /// Returns whether it is known where everything lies that others than this robot hold.
  bool are_others_laid(const RobotId& robot) const;

  /// Looks again at what lies around those places, where somebody holds them.
  void refresh(const TrafficMap& map, Proximity& proximity, const std::vector<PlaceId>& places);
  /// Looks again at what is not laid out yet.
  void refresh_unlaid(const TrafficMap& map, Proximity& proximity);
  /// Looks again at everything.
  void refresh_all(const TrafficMap& map, Proximity& proximity);

 private:
  struct Cells {
    std::uint32_t part = 0;
    std::int64_t left = 0, right = 0, low = 0, high = 0;
    bool is_wide = false;  ///< too many to be kept one by one
  };
  /// Holds one place that somebody touches, and where the indexes have it.
  struct Held {
    RobotId robot;
    LocatedPlace located;
    std::vector<Cells> cells;
  };
  struct Ref {
    const Held* held = nullptr;
    double clearance_m = 0.0;  ///< of the other place, as seen from the one that is held
  };
  using Refs = std::vector<Ref>;
  /// Finds refs by place.
  class ByPlace {
   public:
    Refs& at(const PlaceId& place);
    const Refs* find(const PlaceId& place) const;
    void clear() { rows_.clear(); }

   private:
    std::map<ExperienceId, std::vector<Refs>> rows_;
  };
  using Cell = std::tuple<std::uint32_t, std::int64_t, std::int64_t>;
  using Robot = std::deque<std::unique_ptr<Held>>;

  static Cells cells_of(const Spot& spot, double reach_m);
  std::unique_ptr<Held> held_of(const TrafficMap& map, Proximity& proximity, const RobotId& robot,
                                const Touched& touched) const;
  void add(const Held& held);
  void take_out(const Held& held);
  void renew(const TrafficMap& map, Proximity& proximity, Held& held);
  template <class Meet>
  void for_each_around(const LocatedPlace& here, Meet&& meet) const;
  template <class Meet>
  void for_each_in_cells(const LocatedPlace& here, Meet&& meet) const;

  std::map<RobotId, Robot> robots_;
  ByPlace held_at_;
  ByPlace seen_from_;  ///< by a place that lies around one that is held
  std::map<Cell, Refs> in_cell_;
  std::map<std::uint32_t, Refs> wide_;  ///< by part
  std::map<RobotId, std::size_t> unlaid_;
};

}  // namespace weft::server
