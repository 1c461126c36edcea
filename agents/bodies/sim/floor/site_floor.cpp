#include "agents/bodies/sim/floor/site_floor.hpp"

#include "agents/bodies/sim/floor/marked.hpp"
#include "agents/bodies/sim/floor/photographs.hpp"
#include "agents/bodies/sim/floor/procedural.hpp"

namespace weft::agents::sim {

Result<std::shared_ptr<const FloorSource>> make_site_floor(const Site& site,
                                                           const std::optional<std::string>& photographs,
                                                           const std::function<void(const std::string&)>& warn) {
  const Change& change = site.change;
  auto floor = photographs ? make_photographed_floor(site.floor, *photographs, warn, change.light_warmth)
                           : make_procedural_floor(site.floor, change.light_warmth);
  if (floor && (change.dirt_per_m2 > 0.0 || !change.lines.empty())) return make_marked_floor(*floor, change);
  return floor;
}

}  // namespace weft::agents::sim
