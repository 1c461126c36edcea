#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"

namespace weft::server {

/// Tells how far it is to one berth from any other. Searches backwards from there, no farther than it is asked, and
/// remembers what it found (the reverse search of Silver, "Cooperative pathfinding", AIIDE 2005, without a
/// heuristic).
class Distances {
 public:
  static constexpr double kFar_m = std::numeric_limits<double>::infinity();

  /// Adds so many metres to the drive to a berth that somebody occupies for long: a way round that is shorter is
  /// driven.
  static constexpr double kOccupied_m = 100.0;

  /// Measures ways to `to`. `occupied`: sorted; it does not change. Graph and it must outlive this.
  Distances(BerthGraph& graph, Berth to, std::uint32_t methods, const std::vector<Berth>& occupied);

  /// Returns the metres to be driven from there; `kFar_m`: there is no way.
  double from_m(Berth berth);
  /// Searches for that over so many berths more at most. Returns whether `from_m` knows it without a search.
  bool search(Berth berth, std::size_t most);
  /// Returns the same by that arc.
  double over_m(const BerthArc& arc) { return arc.length_m + more_m(arc.to) + from_m(arc.to); }
  /// Returns what driving to that berth counts beyond its length.
  double more_m(Berth berth) const;
  /// Returns the first of those berths, some of the occupied ones, that the best way from there leads over; kNoBerth:
  /// it does over none, or there is no way.
  Berth leads_over(const std::function<bool(Berth)>& is_one, Berth from);

 private:
  using Entry = std::pair<double, Berth>;

  bool is_settled(Berth berth) const { return berth < is_settled_.size() && is_settled_[berth]; }
  bool is_stop(Berth berth) const { return berth == to_ || graph_.is_cut(berth); }
  void settle_next();
  bool settle(Berth berth, std::size_t& left);
  double over_next_m(Berth berth);
  void reach(Berth berth, double distance_m);

  BerthGraph& graph_;
  Berth to_;
  std::uint32_t methods_;
  const std::vector<Berth>& occupied_;
  std::vector<double> reached_m_;
  std::vector<bool> is_settled_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace weft::server
