#pragma once
#include <vector>

#include "agents/control/grid/ray_cast.hpp"
#include "agents/perception/scan.hpp"
#include "core/geometry/pose2.hpp"
#include "core/random.hpp"

namespace weft::bench {

/// Returns clouds as places of a corridor's crossing have them: of each place 8 frames 0.12 m apart, 75 degrees wide,
/// so many points in 5 cm voxels up to 5 m, on the floor and on walls up to 2.2 m.
std::vector<agents::SeenCloud> crossing_clouds(std::size_t places, std::size_t points, Random& random);

/// Returns a scan of 75 degrees there, with noise.
agents::Scan crossing_scan(const Pose2& chart_from_robot, Random& random);

}  // namespace weft::bench
