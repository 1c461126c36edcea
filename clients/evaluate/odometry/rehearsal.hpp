#pragma once
#include <vector>

#include "agents/bodies/body.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "clients/evaluate/odometry/observer.hpp"
#include "core/result.hpp"

namespace weft::evaluate::odometry {

/// A hand leads the robot along the line while all of them watch; then the truth is written into their traces.
/// False: stopped. Errors of the body.
Result<bool> rehearse(const floor::Drive& drive, const std::vector<agents::SitePoint>& line,
                      std::vector<Observer>& observers);

}  // namespace weft::evaluate::odometry
