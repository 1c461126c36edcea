#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Names a cell of the space of planar poses.
struct PoseCell {
  std::int32_t column = 0;
  std::int32_t row = 0;
  std::int32_t turn = 0;  ///< in [0, turns)

  bool operator==(const PoseCell&) const = default;
};

/// Cuts the space of planar poses into cells: a whole number of headings, of `cell_rad` each or nearly so.
class PoseCells {
 public:
  PoseCells(double cell_m, double cell_rad)
      : cell_m_(cell_m),
        turns_(std::max(1, static_cast<std::int32_t>(std::lround(2.0 * std::numbers::pi / cell_rad)))) {}
  PoseCell at(const Pose2& pose) const {
    const double turned = (wrap_angle(pose.heading) + std::numbers::pi) / (2.0 * std::numbers::pi);
    const auto turn = static_cast<std::int32_t>(std::floor(turned * turns_));
    return {static_cast<std::int32_t>(std::floor(pose.x / cell_m_)),
            static_cast<std::int32_t>(std::floor(pose.y / cell_m_)), turn % turns_};
  }
  std::int32_t turns() const { return turns_; }

 private:
  double cell_m_;
  std::int32_t turns_;
};

/// Numbers distinct cells in the order in which they come. Finds them by open addressing.
class CellNumbers {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Makes room for so many cells at most.
  explicit CellNumbers(std::size_t most);
  /// Returns the number of the cell, a new one if it has none.
  std::size_t number(const PoseCell& cell);
  /// Returns the number of the cell, kNone if it has none.
  std::size_t find(const PoseCell& cell) const;
  std::size_t count() const { return cells_.size(); }
  const PoseCell& cell(std::size_t number) const { return cells_[number]; }

 private:
  std::size_t slot_of(const PoseCell& cell) const;

  std::vector<std::size_t> slots_;
  std::vector<PoseCell> cells_;
};

}  // namespace weft::agents
