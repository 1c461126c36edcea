#pragma once
#include "server/traffic/plan/berth_graph.hpp"

namespace weft::server {

/// Describes a drive that a robot could wish for in a step of the plan.
struct MoveChoice {
  const BerthArc* arc = nullptr;
  bool is_last = false;      ///< makes way into a pocket
  bool is_unwanted = false;  ///< the asker has no use for it
  bool is_free = false;
  double cost_m = 0.0;
};

/// Returns whether `a` is tried before `b`.
inline bool is_better(const MoveChoice& a, const MoveChoice& b) {
  if (a.is_last != b.is_last) return b.is_last;
  if (a.cost_m != b.cost_m) return a.cost_m < b.cost_m;
  if (a.is_unwanted != b.is_unwanted) return a.is_unwanted;
  return a.is_free && !b.is_free;
}

}  // namespace weft::server
