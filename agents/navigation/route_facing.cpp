#include "agents/navigation/route_facing.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace weft::agents {
namespace {

constexpr double kStretch_m = 0.3;   // the direction of a shorter one says little: stitches step back and aside
constexpr double kDriven_rad = 0.8;  // a bend steeper than this is turned on the spot

std::optional<double> direction(const Pose2& from, const Pose2& to) {
  const Eigen::Vector2d way = to.translation() - from.translation();
  if (way.norm() < kStretch_m) return std::nullopt;
  return std::atan2(way.y(), way.x());
}

std::optional<double> direction_to(const std::vector<RoutePose>& poses, std::size_t at) {
  for (std::size_t i = at; i-- > 0;) {
    const auto found = direction(poses[i].robot_from_place, poses[at].robot_from_place);
    if (found) return found;
  }
  return std::nullopt;
}

std::optional<double> direction_from(const std::vector<RoutePose>& poses, std::size_t at) {
  for (std::size_t i = at + 1; i < poses.size(); ++i) {
    const auto found = direction(poses[at].robot_from_place, poses[i].robot_from_place);
    if (found) return found;
  }
  return std::nullopt;
}

/// Turns one place; `to` and `on` are the directions in which the way leads to it and on from it.
void face(RoutePose& pose, double to, double on) {
  Pose2& place = pose.robot_from_place;
  for (const double heading : {place.heading, wrap_angle(place.heading + std::numbers::pi)}) {
    const bool fits =
        std::abs(wrap_angle(heading - to)) <= kDriven_rad && std::abs(wrap_angle(heading - on)) <= kDriven_rad;
    if (!fits) continue;
    place.heading = heading;
    return;
  }
  const double turn = wrap_angle(on - to);
  const bool is_corner = std::abs(turn) > kDriven_rad;
  place.heading = is_corner ? to : wrap_angle(to + 0.5 * turn);
  pose.turn_rad = is_corner ? turn : 0.0;
}

}  // namespace

void face_travel(std::vector<RoutePose>& poses) {
  const std::vector<RoutePose> taught = poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::optional<double> to = direction_to(taught, i);
    const std::optional<double> on = direction_from(taught, i);
    if (to || on) face(poses[i], to ? *to : *on, on ? *on : *to);
  }
}

}  // namespace weft::agents
