#include "agents/bodies/sim/hall/hall.hpp"

#include "agents/bodies/sim/hall/interior.hpp"

namespace weft::agents::sim {

Hall::Hall(const Site& site, const FloorSource& floor)
    : quads_(interior_of(site)), scene_(quads_), textures_(floor, site.floor.seed) {}

}  // namespace weft::agents::sim
