#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "agents/bodies/sim/floor/source.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// What a kind of floor is made of. Amplitudes are grey levels, sizes metres, densities a square metre.
struct Material {
  std::string name;
  /// Noise on lattices of kTexelM, 2 kTexelM, ... up to one tile.
  std::array<float, 11> octaves{};
  double chips_per_m2 = 0.0;
  double chip_least_m = 0.0, chip_most_m = 0.0;  ///< radius
  double chip_dark = 0.0, chip_light = 0.0;      ///< a chip's own level lies between -dark and +light
  double stains_per_m2 = 0.0;
  double stain_grey = 0.0;
  double cracks_per_m2 = 0.0;
  double scuffs_per_m2 = 0.0;    ///< broad faint streaks of wheels
  double joint_spacing_m = 0.0;  ///< saw cuts; 0: none
  double gloss = 0.0;
};
const std::vector<Material>& materials();

/// Never repeats: every lattice value is a hash of its place in the site. not_found: no such material (names those
/// there are).
Result<std::shared_ptr<const FloorSource>> make_procedural_floor(const FloorSetup& setup);

}  // namespace weft::agents::sim
