#pragma once
#include <string_view>
#include <vector>

#include "agents/methods/floor/config.hpp"
#include "agents/perception/planar_motion.hpp"

namespace weft::agents {

/// Says whether pairs of points show one plane, the floor.
struct OnePlane {
  std::string_view refused;    ///< few_tracks, homography_refused, normal_refused; empty: they do
  std::vector<bool> is_on_it;  ///< of each pair; empty when refused
};

/// Finds the pairs that one homography explains within `threshold_px`, and decides by its decomposition whether its
/// plane is the floor (Gadd & Newman, eq. 1 and 2). The best of `pairs` stand first.
OnePlane one_plane(const CameraModel& camera, const FloorConfig& config, const PlanarState& expected,
                   const std::vector<FloorPair>& pairs, double threshold_px);

}  // namespace weft::agents
