#pragma once
#include <optional>

#include "clients/evaluate/ceiling/scenes.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Returns what a robot of that site is given before it drives there: the camera as `weft calibrate mount --method
/// ceiling` finds it on a drive of its own in `scenes.calibration`, and the ceiling's height as somebody has measured
/// it, which is better than what a drive shows of it. The robot is one of the site's, with all that the site says of
/// it. A drive that the calibration refuses is driven again on another day, at most twice, as by a person who is told
/// to. None: stopped. Errors of the body and the calibration, which name the robot.
Result<std::optional<Calibrated>> calibrated(const Scenes& scenes, const agents::sim::Site& site,
                                             const Driven& driven);

}  // namespace weft::evaluate::ceiling
