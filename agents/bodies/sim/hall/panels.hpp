#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"

namespace weft::agents::sim {

inline constexpr double kBeyondM = 1.0;  ///< of a site's bounds, where the hall's own walls stand

/// Cuts a large face into panels, each of another piece of its texture: light is told at their corners.
void add_panels(const Quad& whole, std::vector<Quad>& quads);

/// Returns a face of that stuff, of double coordinates.
Quad face(const Eigen::Vector3d& corner, const Eigen::Vector3d& across, const Eigen::Vector3d& up, Stuff stuff,
          double grey);

}  // namespace weft::agents::sim
