#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/site.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// Add what hangs under a ceiling of that height, with the rods that it hangs on.
void add_duct(const Duct& duct, double ceiling_m, std::vector<Quad>& quads);
void add_pipe(const Pipe& pipe, double ceiling_m, std::vector<Quad>& quads);
void add_skylight(const Skylight& skylight, double ceiling_m, std::vector<Quad>& quads);
void add_sprinkler(double x, double y, double ceiling_m, std::vector<Quad>& quads);
/// Adds a sign as long as an arm, along x or y, no lower than 2.2 m above the floor.
void add_hanging_sign(double x, double y, double ceiling_m, Random& random, std::vector<Quad>& quads);

}  // namespace weft::agents::sim
