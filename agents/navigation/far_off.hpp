#pragma once
#include <cmath>

#include "core/network/relation.hpp"

namespace weft::agents {

/// Returns whether a robot that believes this of the place nearest to it is so far beside it, or so askew, that it
/// may be mistaken, or that what was taught since lies nearer: it looks again before it relies on that.
inline bool is_far_off(const Relation& place_from_robot) {
  constexpr double kFar_m = 0.5;
  constexpr double kAskew_rad = 0.785;  // 45 degrees
  return distance_m(place_from_robot) > kFar_m || std::abs(heading_rad(place_from_robot)) > kAskew_rad;
}

}  // namespace weft::agents
