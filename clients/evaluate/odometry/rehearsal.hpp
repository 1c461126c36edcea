#pragma once
#include <vector>

#include "agents/bodies/body.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "clients/evaluate/odometry/observer.hpp"
#include "core/result.hpp"

namespace weft::evaluate::odometry {

/// Has a hand lead the robot along the line while all of them watch, then writes the truth into their traces. Returns
/// false when it was stopped. Errors of the body.
Result<bool> rehearse(const floor::Drive& drive, const std::vector<agents::SitePoint>& line,
                      std::vector<Observer>& observers);

}  // namespace weft::evaluate::odometry
