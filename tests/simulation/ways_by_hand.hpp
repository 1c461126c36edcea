#pragma once
#include <vector>

#include "agents/bodies/body.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::simulation {

/// Returns lines by which a hand can take a robot from one pose to another, forwards, over open floor: a curve, a
/// straight and a curve (Dubins 1957), the shortest first; at most four.
std::vector<std::vector<agents::SitePoint>> ways_by_hand(const Pose2& from, const Pose2& to);

}  // namespace weft::simulation
