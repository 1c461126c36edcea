#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Describes the traces that months of traffic leave on a floor: crumbs and shreds that lie about, and marks of
/// tyres.
struct FloorWear {
  double specks_per_m2 = 400.0;
  double marks_per_m2 = 1.0;
  double far_m = 1.5;  ///< how far ahead of the robot, and to each side, there is any
};

/// Describes one thing on the floor: its convex outline, robot frame, and how many grey levels brighter it is.
struct Blot {
  std::vector<Eigen::Vector2d> outline_on_floor;
  double grey = 0.0;
};

/// Returns the blots of such wear at random places; each seed gives another wear. Pure.
std::vector<Blot> blots_of(const FloorWear& wear, std::uint64_t seed);

}  // namespace weft::agents
