#pragma once
#include <cstdint>
#include <functional>

#include "server/traffic/plan/berth_graph.hpp"

namespace weft::server {

/// Describes from where a robot is to get out of others' way.
struct WayOut {
  Berth from = kNoBerth;
  std::uint32_t methods = 0;
  std::function<bool(const BerthArc&)> is_closed;  ///< nobody drives there
  std::function<bool(Berth)> is_out;               ///< a robot that stands there is in nobody's way
};

/// Returns the first drive of a way to a berth that is out, by the fewest drives; null: none is near. A robot that
/// follows these from berth to berth never drives in a circle.
const BerthArc* drive_out(BerthGraph& graph, const WayOut& way);

}  // namespace weft::server
