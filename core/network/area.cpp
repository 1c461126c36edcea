#include "core/network/area.hpp"

#include <algorithm>
#include <cmath>

#include "core/network/registration.hpp"
#include "core/text.hpp"

namespace weft {
namespace {

/// Returns twice the area, positive or negative by the order of the corners (the shoelace formula).
double twice_area(const std::vector<Eigen::Vector2d>& corners) {
  double sum = 0.0;
  for (std::size_t at = 0; at < corners.size(); ++at) {
    const Eigen::Vector2d& here = corners[at];
    const Eigen::Vector2d& next = corners[(at + 1) % corners.size()];
    sum += here.x() * next.y() - next.x() * here.y();
  }
  return sum;
}

}  // namespace

std::string problem_of(const std::vector<Eigen::Vector2d>& corners) {
  if (corners.size() < kLeastCorners || corners.size() > kMostCorners)
    return "has " + std::to_string(corners.size()) + " corners";
  if (!std::ranges::all_of(corners, is_on_plan))
    return "has a corner farther than " + short_number(kPlanReach_m) + " m from the plan's origin";
  return std::abs(twice_area(corners)) >= 2.0 * kLeastArea_m2 ? "" : "encloses nothing";
}

}  // namespace weft
