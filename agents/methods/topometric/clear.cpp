// Whether a straight way nobody has driven is free (Dayoub et al. 2013, IV-C: shortcuts).
#include <algorithm>
#include <cmath>

#include "agents/control/grid/clearance.hpp"
#include "agents/control/grid/window.hpp"
#include "agents/methods/topometric/topometric.hpp"

namespace weft::agents {

static_assert(Clears<Topometric>);

bool Topometric::is_clear(const Chart& chart, const Pose2& centre_from_a, const Pose2& a_from_b) const {
  const Eigen::Vector2d from = centre_from_a.translation();
  const Eigen::Vector2d to = (centre_from_a * a_from_b).translation();
  const double length_m = (to - from).norm();
  const double cell_m = chart.grid.raster.cell_m;
  const double radius_m = config_.local.footprint_m;
  const double margin_m = radius_m + 2.0 * cell_m;
  const DistanceMap clearance = clearance_of(window_of(chart.grid, 0.5 * (from + to), length_m + 2.0 * margin_m));
  const int steps = std::max(1, static_cast<int>(std::ceil(length_m / (0.5 * cell_m))));
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector2d at = from + (to - from) * (static_cast<double>(i) / steps);
    if (clearance.at(at) < radius_m) return false;
  }
  return true;
}

}  // namespace weft::agents
