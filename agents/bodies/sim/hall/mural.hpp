#pragma once
#include <cstdint>
#include <vector>

#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Is the picture of a whole ceiling, no part of which is another part's: grey levels about a mean of 128 by place.
struct Mural {
  double x0 = 0.0, y0 = 0.0;  ///< of its first texel, site frame; rows go on with y
  double texel_m = 0.005;
  int side = 1;                      ///< texels, a power of two; more than the hall's
  std::vector<std::uint8_t> texels;  ///< side x side
};

/// Draws the ceiling of a site whose kind is not plain: texels of 5 mm, larger where 4096 of them are shorter than
/// the hall. A function of the kind, the hall's size, `CeilingSetup` and the floor's seed.
Mural draw_mural(const Site& site);

}  // namespace weft::agents::sim
