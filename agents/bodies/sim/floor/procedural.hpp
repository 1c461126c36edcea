#pragma once
#include <memory>

#include "agents/bodies/sim/floor/materials.hpp"
#include "agents/bodies/sim/floor/source.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Makes a floor that never repeats but where it is tiled: every lattice value is a hash of its place in the site.
/// `light_warmth`, -1 (blue) to 1 (red), is the colour of all light: a part of warmth t looks 1 + light_warmth * t
/// times as bright. not_found: no such material (names those there are).
Result<std::shared_ptr<const FloorSource>> make_procedural_floor(const FloorSetup& setup, double light_warmth = 0.0);

}  // namespace weft::agents::sim
