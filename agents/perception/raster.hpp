#pragma once
#include <Eigen/Core>
#include <cmath>
#include <cstddef>

namespace weft::agents {

/// Names a cell of a raster: the column counts along x, the row along y.
struct Cell {
  int column = 0;
  int row = 0;
  bool operator==(const Cell&) const = default;
};

/// Lays square cells over a part of a plane. Cell (0, 0) is the one with the least x and y.
struct Raster {
  double x_m = 0.0;  ///< of the corner of least x and y
  double y_m = 0.0;
  double cell_m = 0.05;
  int columns = 0;
  int rows = 0;

  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  bool holds(const Cell& cell) const {
    return cell.column >= 0 && cell.column < columns && cell.row >= 0 && cell.row < rows;
  }
  /// Returns where the cell's value stands in a vector of all of them, row by row. The raster holds the cell.
  std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(cell.column);
  }
  /// Returns the cell in which a point lies, which may be outside.
  Cell cell_at(const Eigen::Vector2d& point) const {
    return {static_cast<int>(std::floor((point.x() - x_m) / cell_m)),
            static_cast<int>(std::floor((point.y() - y_m) / cell_m))};
  }
  Eigen::Vector2d centre(const Cell& cell) const {
    return {x_m + (cell.column + 0.5) * cell_m, y_m + (cell.row + 0.5) * cell_m};
  }
  bool operator==(const Raster&) const = default;
};

/// Returns a raster of a square with the given middle and side, both in metres.
inline Raster square_raster(const Eigen::Vector2d& middle, double side_m, double cell_m) {
  const int cells = static_cast<int>(std::lround(side_m / cell_m));
  const double half_m = 0.5 * cells * cell_m;
  return {middle.x() - half_m, middle.y() - half_m, cell_m, cells, cells};
}

}  // namespace weft::agents
