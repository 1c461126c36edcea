#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "agents/perception/birds_eye.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::cli {

/// Holds a place's patch and where the place lies in the drawing.
struct LaidPatch {
  Pose2 drawing_from_place;
  agents::PlanePatch patch;
};

/// Holds patches laid together: row 0 has the largest y of the drawing, column 0 the least x.
struct Mosaic {
  std::size_t columns = 0, rows = 0;
  double metres_per_pixel = 0.0;
  Eigen::Vector2d corner_in_drawing = Eigen::Vector2d::Zero();  ///< upper left of the first pixel, metres
  std::vector<std::uint8_t> greys;                              ///< row by row; 0 where no patch shows anything

  /// Returns its lower left and upper right corner in the drawing.
  std::array<Pose2, 2> extent() const;
  /// Returns whether the point, in the drawing, lies within it.
  bool covers(const Eigen::Vector2d& in_drawing) const;
};

/// Lays patches together, as finely as the finest of them, or as coarsely as makes 16 million pixels. Where several
/// show a point, each counts the more the nearer the point is to its middle: seams show how well places agree, and do
/// not flicker. An empty patch shows nothing; there is at least one that is not.
Mosaic lay_mosaic(const std::vector<LaidPatch>& patches);

}  // namespace weft::cli
