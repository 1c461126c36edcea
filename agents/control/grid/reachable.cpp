#include "agents/control/grid/reachable.hpp"

#include <cmath>

namespace weft::agents {

Reachable::Reachable(const RoomToDrive& room, const Eigen::Vector2d& from)
    : raster_(room.clearance().raster), is_reached_(raster_.size(), 0) {
  const Cell start = raster_.cell_at(from);
  if (!raster_.holds(start)) return;
  std::vector<Cell> open{start};
  is_reached_[raster_.index(start)] = 1;
  while (!open.empty()) {
    const Cell at = open.back();
    open.pop_back();
    for (int i = 0; i < 9; ++i) {
      const Cell next{at.column + i % 3 - 1, at.row + i / 3 - 1};
      if (!raster_.holds(next)) continue;
      std::uint8_t& reached = is_reached_[raster_.index(next)];
      if (reached != 0) continue;
      const auto clearance_m = static_cast<double>(room.clearance().metres[raster_.index(next)]);
      if (!room.allows(raster_.centre(next), clearance_m)) continue;
      reached = 1;
      open.push_back(next);
    }
  }
}

std::optional<Eigen::Vector2d> Reachable::nearest(const Eigen::Vector2d& point, double within_m) const {
  const Cell middle = raster_.cell_at(point);
  if (raster_.holds(middle) && is_reached_[raster_.index(middle)] != 0) return point;
  const int reach = static_cast<int>(std::ceil(within_m / raster_.cell_m));
  std::optional<Eigen::Vector2d> found;
  double least_m = within_m;
  for (int row = middle.row - reach; row <= middle.row + reach; ++row) {
    for (int column = middle.column - reach; column <= middle.column + reach; ++column) {
      const Cell cell{column, row};
      if (!raster_.holds(cell) || is_reached_[raster_.index(cell)] == 0) continue;
      const Eigen::Vector2d centre = raster_.centre(cell);
      if ((centre - point).norm() > least_m) continue;
      least_m = (centre - point).norm();
      found = centre;
    }
  }
  return found;
}

}  // namespace weft::agents
