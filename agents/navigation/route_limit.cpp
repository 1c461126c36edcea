#include "agents/navigation/route_limit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace weft::agents {
namespace {

constexpr double kBrakeShare = 0.8;  ///< of its braking that it plans with

/// Returns how far the way leads to that place; beyond what is laid out: to where that ends.
double way_to(const RouteAround& around, std::uint32_t index) {
  double way_m = 0.0;
  const RoutePose* before = &around.poses[around.nearest];
  if (before->index < index) way_m = std::max(0.0, before->robot_from_place.x);
  for (std::size_t i = around.nearest + 1; i < around.poses.size() && around.poses[i].index <= index; ++i) {
    const RoutePose& pose = around.poses[i];
    way_m += (pose.robot_from_place.translation() - before->robot_from_place.translation()).norm();
    before = &pose;
  }
  return way_m;
}

}  // namespace

std::optional<double> route_limit(const Route& route, const RouteAround& around, std::uint32_t at,
                                  double footprint_radius_m, double brake_m_s2) {
  std::optional<double> lowest;
  for (const SpeedLimit& limit : route.limits) {
    if (limit.to < at || around.poses.empty()) continue;
    const double left_m = limit.from <= at ? 0.0 : std::max(0.0, way_to(around, limit.from) - footprint_radius_m);
    const double speed = std::sqrt(limit.limit_m_s * limit.limit_m_s + 2.0 * kBrakeShare * brake_m_s2 * left_m);
    lowest = std::min(lowest.value_or(speed), speed);
  }
  return lowest;
}

}  // namespace weft::agents
