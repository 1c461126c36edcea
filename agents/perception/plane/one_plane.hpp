#pragma once
#include <string_view>
#include <vector>

#include "agents/perception/homography.hpp"
#include "agents/perception/planar_motion.hpp"

namespace weft::agents {

struct OnePlaneBounds {
  std::size_t fewest = 20;              ///< pairs on the plane
  double fewest_share = 0.35;           ///< of all pairs
  double decompose_from_heights = 0.1;  ///< shorter motions say too little about the normal
  DecompositionBounds motion;
};

/// Says whether pairs of points show one plane, the expected one.
struct OnePlane {
  std::string_view refused;    ///< few_tracks, homography_refused, normal_refused; empty: they do
  std::vector<bool> is_on_it;  ///< of each pair; empty when refused
};

/// Finds the pairs that one homography explains within `threshold_px`, and decides by its decomposition whether its
/// plane is the expected one (Gadd & Newman, eq. 1 and 2). The best of `pairs` stand
/// first. `above_floor_m`: of the expected plane.
OnePlane one_plane(const CameraModel& camera, const OnePlaneBounds& bounds, const PlanarState& expected,
                   const std::vector<PlanePair>& pairs, double threshold_px, double above_floor_m = 0.0);

}  // namespace weft::agents
