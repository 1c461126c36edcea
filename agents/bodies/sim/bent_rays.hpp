#pragma once
#include <span>
#include <vector>

#include "agents/bodies/sim/pixel_rays.hpp"
#include "agents/bodies/sim/relief.hpp"
#include "core/geometry/pose3.hpp"

namespace weft::agents::sim {

/// Holds the point where a line of sight meets an uneven floor.
struct FloorMet {
  Eigen::Vector2d at;                  ///< site frame
  float bend_x = 0.0F, bend_y = 0.0F;  ///< how the ray that meets the plane straight below there differs, normalised
};
/// Finds where a line of sight meets the uneven floor. `on_plane`: where it meets the plane, from the same eye.
FloorMet meet_floor(const Relief& relief, const Pose3& site_from_camera, const Eigen::Vector2d& on_plane);

/// Bends rays of pixels so that they meet the floor's plane where the pixels' own rays meet the uneven floor: what
/// samples a plane along them sees the uneven one. How they bend is known at the nodes of a grid over the image and
/// interpolated between.
class BentRays {
 public:
  /// Makes a grid of nodes, one every `cell` pixels; `columns` x `rows` of them, row-major.
  BentRays(int cell, int columns, int rows);
  void set(std::size_t node, const FloorMet& met);
  /// Bends the rays of the pixels from (u, v) on, as many as there are; u is a multiple of the cell, and so is their
  /// number.
  void bend(int u, int v, std::span<const float> ray_x, std::span<const float> ray_y);
  const float* x() const { return x_.data(); }
  const float* y() const { return y_.data(); }

 private:
  int cell_, columns_;
  std::vector<float> bend_x_, bend_y_;  ///< of each node
  std::vector<float> x_, y_;            ///< as bent last
};

}  // namespace weft::agents::sim
