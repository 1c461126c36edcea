#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"
#include "server/traffic/plan/by_berth.hpp"

namespace weft::server {

/// Keeps the drives between berths where robots may stop, side by side, for searches that go over many of them. To be
/// used for one plan: berths that get numbers later change drives.
class CutArcs {
 public:
  explicit CutArcs(BerthGraph& graph) : graph_(graph) {}

  struct Arc {
    Berth to = kNoBerth;
    std::span<const Berth> touches;
  };
  /// Returns the drives from there on that end at a berth where robots may stop, in the graph's order. Good until the
  /// next call.
  std::span<const Arc> next(Berth from, std::uint32_t methods) {
    while (methods >= by_methods_.size()) by_methods_.emplace_back();
    Range& range = by_methods_[methods].at(from);
    if (!range.is_known) range = look(from, methods);
    return {arcs_.data() + range.first, range.size};
  }

 private:
  struct Range {
    std::size_t first = 0;
    std::size_t size = 0;
    bool is_known = false;
  };

  Range look(Berth from, std::uint32_t methods) {
    const std::size_t first = arcs_.size();
    for (const BerthArc& arc : graph_.next(from, methods)) {
      if (graph_.is_cut(arc.to)) arcs_.push_back({arc.to, arc.touches});
    }
    return {first, arcs_.size() - first, true};
  }

  BerthGraph& graph_;
  std::vector<Arc> arcs_;
  std::vector<ByBerth<Range>> by_methods_;
};

}  // namespace weft::server
