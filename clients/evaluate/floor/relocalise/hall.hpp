#pragma once
#include <vector>

#include "agents/bodies/body.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::evaluate::floor {

/// Describes a hall with room for a long way: no racks, lamps every few metres.
struct Hall {
  agents::sim::Site site;               ///< its first robot stands where the line begins
  std::vector<agents::SitePoint> line;  ///< to and fro in rows, each turned into the next by a half circle
};

/// Makes a hall with camera, base, hand, disturbances and floor of `like`, and a line of at least so many metres.
Hall hall_like(const agents::sim::Site& like, double metres);

}  // namespace weft::evaluate::floor
