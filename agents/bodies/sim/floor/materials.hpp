#pragma once
#include <array>
#include <string>
#include <vector>

namespace weft::agents::sim {

/// Describes what a kind of floor is made of. Amplitudes are grey levels, sizes metres, densities a square metre.
struct Material {
  /// Names the kind of pieces that are laid under everything else.
  enum class Pieces : unsigned char { none, tiles, planks };

  std::string name;
  /// Holds the amplitudes of noise on lattices of kTexelM, 2 kTexelM, ... up to one tile.
  std::array<float, 11> octaves{};
  Pieces pieces = Pieces::none;
  double chips_per_m2 = 0.0;
  double chip_least_m = 0.0, chip_most_m = 0.0;  ///< radius
  double chip_dark = 0.0, chip_light = 0.0;      ///< a chip's own level lies between -dark and +light
  double stains_per_m2 = 0.0;
  double stain_grey = 0.0;
  double cracks_per_m2 = 0.0;
  double fissures_per_m2 = 0.0;  ///< wide, jagged cracks of a metre or two, with branches
  double scuffs_per_m2 = 0.0;    ///< broad faint streaks of wheels
  double tyres_per_m2 = 0.0;     ///< dark bends of a few metres that forklifts leave
  double joint_spacing_m = 0.0;  ///< saw cuts; 0: none
  double gloss = 0.0;
  double warmth = 0.0;         ///< mean, from -1 (blue) by 0 (grey) to 1 (red)
  double warmth_spread = 0.0;  ///< how much its parts differ in it
};
const std::vector<Material>& materials();

}  // namespace weft::agents::sim
