#pragma once
#include <cstdint>
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "clients/evaluate/topometric/moment.hpp"

/// Judges how near a robot has come to what it must not touch. All pure.
namespace weft::evaluate::topometric {

/// Returns the distance from the robot's rim to the nearest wall, rack, obstacle or mover at each moment, metres;
/// negative: it is over it. `day`: which obstacles stand there.
std::vector<double> clearances_m(const agents::sim::Site& site, std::uint64_t day, const Moments& moments);

/// Counts the moments at which the robot began to touch something.
double contacts(const Moments& moments);

}  // namespace weft::evaluate::topometric
