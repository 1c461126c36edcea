#pragma once
#include <limits>
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// Returns how bright each of the site's lamps is in a run, against what the site file says: within
/// `Disturbances::light_change` of 1, as `random` makes it; 0 for the nearest whole number to `Change::lamps_failed`
/// of them, drawn by `Change::seed`.
std::vector<double> lamps_now(const Site& site, Random random);

/// Returns the share of its light that a lamp gives at a body's time, s: 1; less while it flickers, by its place and
/// the time; 0 once it has ended.
double share_at(const Lamp& lamp, double time_s);
/// Returns whether a lamp is ever less bright in a run than at another time of it.
inline bool is_unsteady(const Lamp& lamp) {
  return lamp.flicker > 0.0 || lamp.ends_s < std::numeric_limits<double>::infinity();
}

}  // namespace weft::agents::sim
