#pragma once
#include <cstdint>
#include <cstdlib>

namespace weft::agents {

/// Describes an offset between two cells of a raster.
struct CellOffset {
  int columns = 0;
  int rows = 0;
};

/// Numbers the straight lines from one cell to all cells of the square ring that is `steps` cells away. A line has
/// one cell a step along its longer axis, as Bresenham's; the one nearest to a cell of distance d passes its middle
/// by at most (1 + d / steps) / 2 cells. Many rays share one line, so that they are walked once.
class RayLines {
 public:
  explicit RayLines(int steps) : steps_(steps) {}
  int steps() const { return steps_; }
  int count() const { return 4 * beside(); }
  /// Returns how many steps along its line a cell is away.
  static int steps_to(const CellOffset& to) {
    const int columns = std::abs(to.columns);
    const int rows = std::abs(to.rows);
    return columns > rows ? columns : rows;
  }
  /// Returns the number of the line that leads nearest to a cell, which is at most `steps` away.
  int line_to(const CellOffset& to) const {
    const bool is_along_x = std::abs(to.columns) >= std::abs(to.rows);
    const int along = is_along_x ? to.columns : to.rows;
    const int across = is_along_x ? to.rows : to.columns;
    if (along == 0) return steps_;
    const int length = std::abs(along);
    const int twice = 2 * across * steps_ + (across < 0 ? -length : length);
    const int sector = (is_along_x ? 0 : 2) + (along < 0 ? 1 : 0);
    return sector * beside() + steps_ + twice / (2 * length);
  }

  /// Walks a line: gives the offset of any step on it.
  class Walk {
   public:
    Walk(const RayLines& lines, int line)
        : is_along_x_(line / lines.beside() < 2),
          sign_((line / lines.beside()) % 2 == 0 ? 1 : -1),
          slope_(((line % lines.beside() - lines.steps_) * kOne) / lines.steps_) {}
    CellOffset at(int step) const {
      const int across = (slope_ * step + kOne / 2) >> kShift;
      return is_along_x_ ? CellOffset{sign_ * step, across} : CellOffset{across, sign_ * step};
    }

   private:
    static constexpr int kShift = 16;
    static constexpr int kOne = 1 << kShift;
    bool is_along_x_;
    int sign_;
    int slope_;
  };

 private:
  int beside() const { return 2 * steps_ + 1; }
  int steps_;
};

}  // namespace weft::agents
