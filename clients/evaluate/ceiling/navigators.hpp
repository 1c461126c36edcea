#pragma once
#include "agents/methods/ceiling/ceiling.hpp"
#include "clients/evaluate/floor/driven_robot.hpp"

namespace weft::evaluate::ceiling {

using Look = floor::Watched<agents::Ceiling>::Look;

/// Makes navigators of the method `ceiling` as an agent has them, with these settings; `look` is told each sample.
floor::MakeNavigator ceiling_navigator(const agents::CeilingConfig& settings, Look look = {});

/// Returns settings with which the method takes all that it sees for one plane, the ceiling.
agents::CeilingConfig one_plane(agents::CeilingConfig settings);

}  // namespace weft::evaluate::ceiling
