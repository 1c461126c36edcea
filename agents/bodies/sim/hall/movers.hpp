#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Returns where a mover is at a time, s: to and fro along its way at its speed, heading as it goes.
Pose2 pose_of(const Mover& mover, double time_s);

/// Adds a person who has walked so far and stands there, as boxes; `who` tells one from another.
void add_person(const Pose2& pose, std::uint32_t who, double walked_m, std::vector<Quad>& quads);

/// Adds a person or forklift as boxes that look like one, at a time, s; `who` tells one from another.
void add_mover(const Mover& mover, std::uint32_t who, double time_s, std::vector<Quad>& quads);

}  // namespace weft::agents::sim
