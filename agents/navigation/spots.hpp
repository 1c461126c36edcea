#pragma once
#include <cstddef>
#include <optional>

#include "agents/navigation/route_ahead.hpp"

namespace weft::agents {

/// Holds positions in the poses of a route between which the robot turns on the spot; both are the same where the
/// route itself has a corner.
struct Spot {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Returns whether the hop from `a` to `b` turns the robot on the spot.
bool on_the_spot(const RoutePose& a, const RoutePose& b);

/// Returns the first spot from the place nearest to the robot on at which it has yet to turn; none: there is none.
std::optional<Spot> next_spot(const RouteAround& around);

/// Returns the heading of the way on from a place.
double heading_on(const RoutePose& pose);

/// Returns a place as it is driven through: at a corner, as the robot leaves it.
Pose2 robot_from_way_on(const RoutePose& pose);

}  // namespace weft::agents
