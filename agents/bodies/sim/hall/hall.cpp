#include "agents/bodies/sim/hall/hall.hpp"

#include "agents/bodies/sim/hall/interior.hpp"

namespace weft::agents::sim {

Hall::Hall(const Site& site, const FloorSource& floor, const Photographed& photographed)
    : quads_(interior_of(site)),
      scene_(quads_),
      textures_(floor, site.floor.seed, photographed,
                site.hall.ceiling.kind == CeilingKind::plain ? std::nullopt : std::optional(draw_mural(site))) {}

}  // namespace weft::agents::sim
