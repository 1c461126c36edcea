#pragma once
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Where it is at a time: to and fro along its way at its speed, heading as it goes.
Pose2 pose_of(const Mover& mover, double time_s);

/// People and forklifts as boxes that look like them, at a time.
void add_movers(const std::vector<Mover>& movers, double time_s, std::vector<Quad>& quads);

}  // namespace weft::agents::sim
