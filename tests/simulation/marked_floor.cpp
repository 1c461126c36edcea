#include "tests/simulation/marked_floor.hpp"

#include <algorithm>
#include <cmath>

namespace weft::simulation {

MarkedFloor::MarkedFloor(double x_m, double y_m, int columns, int rows, Random random)
    : x_m_(x_m), y_m_(y_m), columns_(columns), rows_(rows), cells_(static_cast<std::size_t>(columns * rows)) {
  std::uint64_t number = 1;
  for (double y = y_m; y < y_m + rows; y += 0.6) {
    for (double x = x_m; x < x_m + columns; x += 0.6) {
      const Pose2 pose{x + random.uniform(-0.2, 0.2), y + random.uniform(-0.2, 0.2), random.uniform(-3.0, 3.0)};
      const std::uint64_t shown = random.chance(0.02) ? 1 + random.below(number) : number;
      cell_of(pose.x, pose.y).push_back({shown, pose});
      ++number;
    }
  }
}

std::vector<MarkedFloor::Mark>& MarkedFloor::cell_of(double x, double y) {
  const int column = std::clamp(static_cast<int>(std::floor(x - x_m_)), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>(std::floor(y - y_m_)), 0, rows_ - 1);
  return cells_[static_cast<std::size_t>(row * columns_ + column)];
}

std::vector<agents::Marks::Sighting> MarkedFloor::seen_from(const Pose2& site_from_robot) const {
  std::vector<agents::Marks::Sighting> seen;
  const Pose2 robot_from_site = site_from_robot.inverse();
  const Eigen::Vector2d middle = site_from_robot * Eigen::Vector2d(1.0, 0.0);
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const int column = static_cast<int>(std::floor(middle.x() - x_m_)) + dx;
      const int row = static_cast<int>(std::floor(middle.y() - y_m_)) + dy;
      if (column < 0 || column >= columns_ || row < 0 || row >= rows_) continue;
      for (const Mark& mark : cells_[static_cast<std::size_t>(row * columns_ + column)]) {
        const Pose2 robot_from_mark = robot_from_site * mark.site_from_mark;
        if (robot_from_mark.x > 0.2 && robot_from_mark.x < 1.8 && std::abs(robot_from_mark.y) < 0.9) {
          seen.push_back({mark.number, robot_from_mark});
        }
      }
    }
  }
  return seen;
}

}  // namespace weft::simulation
