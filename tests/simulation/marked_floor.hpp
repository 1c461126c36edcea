#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/random.hpp"
#include "tests/support/marks.hpp"

namespace weft::simulation {

/// Holds numbered marks all over a floor. Some carry a number that another one carries too.
class MarkedFloor {
 public:
  /// Lays marks from (x, y) on, in whole metres.
  MarkedFloor(double x_m, double y_m, int columns, int rows, Random random);

  /// Returns what stands within the camera's view of a robot, without noise; `mark` as the robot reads it.
  std::vector<agents::Marks::Sighting> seen_from(const Pose2& site_from_robot) const;

 private:
  struct Mark {
    std::uint64_t number = 0;
    Pose2 site_from_mark;
  };
  std::vector<Mark>& cell_of(double x, double y);

  double x_m_;
  double y_m_;
  int columns_;
  int rows_;
  std::vector<std::vector<Mark>> cells_;
};

}  // namespace weft::simulation
