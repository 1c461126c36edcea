#pragma once
#include <vector>

#include "agents/navigation/route_ahead.hpp"

namespace weft::agents {

/// Returns the released places ahead as they lie, from one behind the robot on, for a method that steers itself. They
/// end where the robot is to turn on the spot as it was taught.
PathAhead released_places(const Route& route, const RouteAround& around);

/// Returns how far the robot is from the straight lines that lead to the place nearest to it and on from there,
/// metres.
double away_from_way_m(const RouteAround& around);

/// Returns the way that is left, metres, along straight lines through places in the robot's frame, from where it is
/// nearest to the robot to its end.
double way_left_m(const std::vector<Pose2>& robot_from_path);

}  // namespace weft::agents
