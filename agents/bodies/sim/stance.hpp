#pragma once
#include "agents/bodies/sim/relief.hpp"
#include "agents/bodies/sim/site.hpp"
#include "core/geometry/pose3.hpp"

namespace weft::agents::sim {

/// Returns the pose of a body that stands on an uneven floor over this pose of the plane: as high and as tilted as
/// the plane that fits best to the floor under its wheels (`track_m` apart) and under its ends (`radius_m` before and
/// behind).
Pose3 stance_on(const Relief& relief, const BaseSetup& base, const Pose2& site_from_robot);

}  // namespace weft::agents::sim
