#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace weft::agents {

/// Sorts points of a level plane into cells of half a metre, to ask for those near another point. Points are added
/// one by one and named by the order in which they were.
class CornerGrid {
 public:
  static constexpr double cell_m = 0.5;

  /// Makes a grid for points between two corners, x and y each.
  CornerGrid(const Eigen::Vector2d& low, const Eigen::Vector2d& high)
      : low_(low), columns_(cells_over(high.x() - low.x())), rows_(cells_over(high.y() - low.y())) {
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  }

  void add(const Eigen::Vector2d& point) { cells_[at(column(point.x()), row(point.y()))].push_back(count_++); }

  /// Calls `visit(number)` for each point of the cells that the square about `point` touches, cell by cell.
  template <class Visit>
  void near(const Eigen::Vector2d& point, double half_m, const Visit& visit) const {
    for (int r = row(point.y() - half_m); r <= row(point.y() + half_m); ++r)
      for (int c = column(point.x() - half_m); c <= column(point.x() + half_m); ++c)
        for (const std::uint32_t number : cells_[at(c, r)]) visit(number);
  }

 private:
  static int cells_over(double metres) { return static_cast<int>(std::max(metres, 0.0) / cell_m) + 1; }
  int column(double x) const { return clamped((x - low_.x()) / cell_m, columns_); }
  int row(double y) const { return clamped((y - low_.y()) / cell_m, rows_); }
  static int clamped(double cells, int count) {
    return static_cast<int>(std::clamp(std::floor(cells), 0.0, count - 1.0));
  }
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  Eigen::Vector2d low_;
  int columns_;
  int rows_;
  std::vector<std::vector<std::uint32_t>> cells_;
  std::uint32_t count_ = 0;
};

}  // namespace weft::agents
