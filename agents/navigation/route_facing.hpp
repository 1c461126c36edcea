#pragma once
#include <vector>

#include "agents/navigation/route_ahead.hpp"

namespace weft::agents {

/// Turns the places of a route that is driven in either direction to how the robot faces there: as they were taught
/// where that is about the way it drives, or the other way round, else as their positions lead. Where the way turns
/// more sharply than is driven it has a corner (RoutePose::turn_rad).
void face_travel(std::vector<RoutePose>& poses);

}  // namespace weft::agents
