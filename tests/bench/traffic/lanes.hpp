#pragma once
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/result.hpp"

namespace weft::bench {

/// Numbers a cell: room for one robot, 1.4 m from its neighbours.
using Cell = std::uint32_t;
inline constexpr Cell kNoCell = ~Cell{0};
inline constexpr double kCell_m = 1.4;

/// Holds a floor of squares, as movingai writes it (octile) and the League of Robot Runners after it.
struct Grid {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<bool> is_free;  ///< row by row
};
Result<Grid> read_grid(std::istream& text);
/// Makes shelves of ten squares, two rows deep, in so many columns and rows; lanes lead around each, at both ends
/// too.
Grid warehouse(std::uint32_t columns, std::uint32_t rows);

/// Tells in which directions a grid's lanes are driven: rows y / 3 and columns x / 11 alternate, or all both ways.
enum class Lanes : std::uint8_t { one_way, two_way };

/// Holds cells, and which of them can be driven to from each. Every cell can be reached from every other one.
struct Network {
  std::vector<Eigen::Vector2d> at;  ///< metres
  std::vector<std::vector<Cell>> next;
  std::vector<std::vector<Cell>> before;

  std::size_t size() const { return at.size(); }
  bool leads(Cell from, Cell to) const;
};
Network network_of(const Grid& grid, Lanes lanes);
/// Makes a ring of so many cells driven one way, with dead ends of eight cells that are driven both ways.
Network ring(std::uint32_t cells, std::uint32_t dead_ends);

/// Returns how many cells lie on the way to `to`, from each.
std::vector<std::uint32_t> steps_to(const Network& network, Cell to);

}  // namespace weft::bench
