#include "agents/navigation/spots.hpp"

#include <cmath>
#include <vector>

namespace weft::agents {
namespace {

constexpr double kTurnCounts_rad = 0.35;  // less than this is driven, not turned
constexpr double kAtCorner_m = 0.1;       // a robot nearer than this may have turned there
constexpr double kTurned_rad = 0.8;       // and has, where the way on lies no further aside

/// Returns whether the robot has yet to turn at a corner of the route.
bool is_due(const RoutePose& pose, bool is_ahead) {
  if (pose.turn_rad == 0.0) return false;
  const bool is_before = is_ahead && pose.robot_from_place.translation().norm() > kAtCorner_m;
  return is_before || std::abs(heading_on(pose)) > kTurned_rad;
}

}  // namespace

bool on_the_spot(const RoutePose& a, const RoutePose& b) {
  constexpr double on_the_spot_m = 0.05;  // a hop shorter than this that turns is no driving
  constexpr double least_turn_rad = 0.025;
  const Pose2 hop = a.robot_from_place.inverse() * b.robot_from_place;
  return hop.translation().norm() < on_the_spot_m && std::abs(hop.heading) > least_turn_rad;
}

std::optional<Spot> next_spot(const RouteAround& around) {
  const std::vector<RoutePose>& poses = around.poses;
  const auto stays = [&](std::size_t i) { return on_the_spot(poses[i], poses[i + 1]); };
  for (std::size_t i = around.nearest; i < poses.size(); ++i) {
    if (is_due(poses[i], i > around.nearest)) return Spot{i, i};
    if (i + 1 == poses.size() || !stays(i)) continue;
    Spot spot{i, i + 1};
    while (spot.last + 1 < poses.size() && stays(spot.last)) ++spot.last;
    const double turn = wrap_angle(poses[spot.last].robot_from_place.heading - poses[i].robot_from_place.heading);
    if (std::abs(turn) > kTurnCounts_rad) return spot;
    i = spot.last - 1;
  }
  return std::nullopt;
}

double heading_on(const RoutePose& pose) {
  return pose.turn_rad == 0.0 ? pose.robot_from_place.heading
                              : wrap_angle(pose.robot_from_place.heading + pose.turn_rad);
}

Pose2 robot_from_way_on(const RoutePose& pose) {
  Pose2 on = pose.robot_from_place;
  on.heading = heading_on(pose);
  return on;
}

}  // namespace weft::agents
