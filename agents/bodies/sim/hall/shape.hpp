#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents::sim {

/// Returns what a box of that stuff looks like.
inline Quad painted(Stuff stuff, float grey, std::uint32_t pattern) {
  Quad quad;
  quad.stuff = stuff;
  quad.grey = grey;
  quad.pattern = pattern;
  return quad;
}

/// Adds boxes in the frame of a thing that stands on the floor, x ahead.
struct Shape {
  const Pose2& pose;
  std::vector<Quad>& quads;
  void add(double x, double y, double z, double length, double width, double height, const Quad& looks) const {
    const Eigen::Vector2d at = pose * Eigen::Vector2d(x, y);
    add_box({{at.x(), at.y(), z}, pose.heading, length, width, height}, looks, quads);
  }
};

}  // namespace weft::agents::sim
