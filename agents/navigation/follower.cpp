#include "agents/navigation/follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/control/spline.hpp"
#include "agents/navigation/route_limit.hpp"
#include "agents/navigation/speed_limit.hpp"

namespace weft::agents {

namespace {

std::uint32_t end_of(const Route& route) {
  return std::min(route.released, static_cast<std::uint32_t>(route.places.size() - 1));
}

bool ends_at_goal(const Route& route) {
  return !route.ended && route.released + 1 >= route.places.size();
}

/// Shortens the path by `metres` at its end.
void shorten(std::vector<Pose2>& path, double metres) {
  path.back() = path.back() * Pose2{-metres, 0.0, 0.0};
  while (path.size() > 1 && (path[path.size() - 2].inverse() * path.back()).x < 0.01) {
    path.erase(path.end() - 2);
  }
}

}  // namespace

void Follower::follow(const Route& route, std::uint32_t from) {
  const bool same_end = route_ && route_->id == route.id && route_->places == route.places;
  if (same_end && route_->released == route.released && route_->ended == route.ended) {
    route_ = route;
    return;
  }
  if (!same_end) {
    // Another version is another list of places: where the robot is on it shows at the next look.
    at_.reset();
    freed_ = 0;
    stuck_ = {};
    turning_to_.reset();
  }
  if (!at_ && from > 0) at_ = from;
  route_ = route;
  arrived_ = false;
  at_end_ = false;
  arrival_.reset();
}

void Follower::stop() {
  *this = Follower(config_);
}

void Follower::fill(Navigated& navigated) const {
  navigated.route_at = at_.value_or(0);
  navigated.route_freed = freed_;
}

void Follower::standing(Navigated& navigated, Following following, std::string_view reason) {
  tracker_.reset();
  navigated.following = following;
  navigated.reason = reason;
}

void Follower::progress(const RouteAround& around) {
  const std::vector<RoutePose>& poses = around.poses;
  constexpr double reached_m = 0.03;
  std::uint32_t at = poses[around.nearest].index;
  const Pose2 place_from_robot = poses[around.nearest].robot_from_place.inverse();
  if (place_from_robot.x < -reached_m && at > 0) --at;
  at_ = std::max(at_.value_or(0), std::min(at, end_of(*route_)));

  // Behind the footprint, along the way that was driven and as the crow flies.
  constexpr double margin_m = 0.1;
  const double clear_m = config_.follow.footprint_radius_m + margin_m;
  std::uint32_t freed = poses.front().index;
  for (const RoutePose& pose : poses) {
    if (pose.index > *at_ || pose.robot_from_place.translation().norm() <= clear_m) break;
    freed = pose.index;
  }
  freed_ = std::max(freed_, std::min(freed, *at_));

  near_.clear();
  for (const RoutePose& pose : poses) {
    if (pose.index + 3 >= *at_ && pose.index <= *at_ + 8) near_.insert(route_->places[pose.index]);
  }
}

Follower::Drive Follower::turn_on_the_spot(const RouteAround& around) {
  constexpr double turned_rad = 0.05;
  Drive drive;
  const auto target = std::find_if(around.poses.begin(), around.poses.end(),
                                   [&](const RoutePose& pose) { return pose.index == *turning_to_; });
  if (target != around.poses.end()) {
    drive.navigated.command = tracker_.turn(config_.tracker, target->robot_from_place.heading, turned_rad);
  }
  if (drive.navigated.command.angular_rad_s == 0.0) {
    at_ = std::max(at_.value_or(0), *turning_to_);
    turning_to_.reset();
  }
  fill(drive.navigated);
  drive.navigated.following = Following::driving;
  return drive;
}

Follower::Drive Follower::end_of_path(const RouteAround& around, const Estimate& estimate) {
  Drive drive;
  fill(drive.navigated);
  if (!ends_at_goal(*route_)) {
    standing(drive.navigated, Following::waiting, route_->ended ? "route_ended" : "waits_for_release");
    return drive;
  }
  if (!arrival_.begun()) arrival_.begin();
  constexpr double fresh_m = 0.01;
  const Arrival::Out out = arrival_.step(config_.follow, config_.tracker, around.poses.back().robot_from_place,
                                         estimate.blind_m <= fresh_m);
  arrived_ = out.arrived;
  drive.navigated.command = out.command;
  if (!out.reason.empty()) {
    standing(drive.navigated, Following::failed, out.reason);
    return drive;
  }
  drive.navigated.following = arrived_ ? Following::arrived : Following::driving;
  return drive;
}

Follower::Drive Follower::stuck(Drive drive, const Seen& seen, std::string_view reason) {
  stuck_ += seen.elapsed;
  const bool gives_up = seconds(stuck_) > config_.follow.give_up_s;
  standing(drive.navigated, gives_up ? Following::failed : Following::stopped, reason);
  return drive;
}

Follower::Drive Follower::look(const Seen& seen) {
  Drive drive;
  fill(drive.navigated);
  if (!route_ || route_->places.empty()) {
    standing(drive.navigated, Following::none, {});
    return drive;
  }
  if (arrived_) {
    standing(drive.navigated, Following::arrived, {});
    return drive;
  }
  if (seen.lost || !seen.estimate) {
    standing(drive.navigated, Following::stopped, seen.lost ? "lost" : "not_localised");
    return drive;
  }
  const std::optional<Joint> found = joint(config_, seen.window, *route_, *seen.estimate, at_.value_or(0));
  if (!found) return stuck(std::move(drive), seen, "route_not_joined");
  const RouteAround around = agents::around(config_, *route_, *found, seen.estimate->place_from_robot, at_);
  // Its route may come by where it stands once more, beyond what is released.
  if (around.poses.back().index > end_of(*route_)) return stuck(std::move(drive), seen, "beyond_release");
  if (around.poses[around.nearest].robot_from_place.translation().norm() > config_.follow.join_m) {
    return stuck(std::move(drive), seen, "off_route");
  }
  const Duration stood = std::exchange(stuck_, {});
  progress(around);
  PathAhead ahead = path_ahead(config_, *route_, around);
  if (turning_to_) return turn_on_the_spot(around);
  if (at_end_ || arrival_.begun()) return end_of_path(around, *seen.estimate);

  if (ahead.reaches_end && !ahead.turn_to_rad && !ends_at_goal(*route_)) {
    shorten(ahead.robot_from_path, config_.follow.stop_short_m);
  }
  fill(drive.navigated);
  drive.navigated.following = Following::driving;
  const double sure_m_s = speed_limit(config_.follow, *seen.estimate);
  const double limit_m_s =
      route_limit(*route_, around, *at_, config_.follow.footprint_radius_m, config_.tracker.speed.deceleration_m_s2)
          .value_or(sure_m_s);
  drive.along = Ahead{std::move(ahead.robot_from_path),
                      0.0,
                      ahead.reaches_end && ends_at_goal(*route_),
                      std::min(sure_m_s, limit_m_s),
                      seen.speed_m_s,
                      !std::holds_alternative<AlongPath>(seen.estimate->place_from_robot),
                      seen.elapsed};
  Result<Spline> path = Spline::through(drive.along->robot_from_path);
  if (!path) {
    standing(drive.navigated, Following::stopped, "route_makes_no_path");
    drive.along.reset();
    return drive;
  }
  const double along_m = path->nearest({0.0, 0.0}, -1.0, path->length_m() + 1.0);
  drive.along->to_end_m = path->length_m() - along_m;
  const bool stands = std::abs(seen.speed_m_s) < 0.02;
  if (ahead.reaches_end && drive.along->to_end_m <= config_.tracker.stop_at_m && stands) {
    if (ahead.turn_to_rad) {
      turning_to_ = ahead.turn_reaches;
      return turn_on_the_spot(around);
    }
    at_end_ = true;
    return end_of_path(around, *seen.estimate);
  }
  if (!ahead.reaches_end && path->length_m() <= 0.0) {
    // Nothing ahead of it on this route can be bent into: another route may lead there.
    standing(drive.navigated, Following::failed, "route_makes_no_path");
    drive.along.reset();
    return drive;
  }
  if (!ahead.reaches_end && drive.along->to_end_m <= config_.tracker.stop_at_m && stands) {
    // All that comes next on this route lies beside or behind the robot.
    stuck_ = stood;
    drive.along.reset();
    return stuck(std::move(drive), seen, "route_makes_no_path");
  }
  drive.path = std::move(*path);
  return drive;
}

Steering Follower::steer(const Ahead& ahead, const Spline& path) {
  return tracker_
      .track(config_.tracker, path, ahead.speed_limit_m_s, {ahead.speed_m_s, ahead.knows_aside, ahead.elapsed})
      .command;
}

}  // namespace weft::agents
