#include "agents/bodies/sim/hall/hall.hpp"

#include "agents/bodies/sim/hall/interior.hpp"

namespace weft::agents::sim {

Hall::Hall(const Site& site, const FloorSource& floor, const Photographed& photographed)
    : quads_(interior_of(site)), scene_(quads_), textures_(floor, site.floor.seed, photographed) {}

}  // namespace weft::agents::sim
