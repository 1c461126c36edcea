#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"
#include "server/traffic/plan/by_berth.hpp"

namespace weft::server {

/// Keeps which robots are on which drives between berths where robots may stop, for searches that go over many of
/// these. Serves one plan only: berths that get numbers later change drives.
class OccupiedArcs {
 public:
  explicit OccupiedArcs(BerthGraph& graph) : graph_(graph) {}

  struct Arc {
    Berth to = kNoBerth;
    std::uint32_t occupants = 0;  ///< how many stand on it; one that stands where two drives lead by is on both
    std::span<const Berth> touches;
  };
  /// Returns the drives from there on that end at a berth where robots may stop, in the graph's order. Valid until
  /// the next call.
  std::span<const Arc> next(Berth from, std::uint32_t methods);
  /// Notes that one more stands there, or one less.
  void occupy(Berth berth) { count(berth, 1); }
  void vacate(Berth berth) { count(berth, -1); }
  /// Returns a berth on that drive at which somebody stands; kNoBerth: there is none.
  Berth occupied_on(const Arc& arc);

 private:
  struct Range {
    std::size_t first = 0;
    std::size_t size = 0;
    bool is_known = false;
  };
  struct Known {
    std::uint32_t occupants = 0;
    std::vector<std::size_t> touched_by;  ///< arcs, by index
  };

  Range look(Berth from, std::uint32_t methods);
  void count(Berth berth, int more);

  BerthGraph& graph_;
  std::vector<Arc> arcs_;
  std::vector<ByBerth<Range>> by_methods_;
  ByBerth<Known> berths_;
};

}  // namespace weft::server
