#include "agents/navigation/follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/control/spline.hpp"
#include "agents/navigation/released_places.hpp"
#include "agents/navigation/route_limit.hpp"
#include "agents/navigation/speed_limit.hpp"
#include "agents/navigation/spots.hpp"

/// Decides how a robot goes on that knows where it is on its route.
namespace weft::agents {

namespace {

bool ends_at_goal(const Route& route) {
  return !route.ended && route.released + 1 >= route.places.size();
}

bool is_still(double speed_m_s) {
  constexpr double still_m_s = 0.02;
  return std::abs(speed_m_s) < still_m_s;
}

/// Shortens the path by `metres` at its end.
void shorten(std::vector<Pose2>& path, double metres) {
  path.back() = path.back() * Pose2{-metres, 0.0, 0.0};
  while (path.size() > 1 && (path[path.size() - 2].inverse() * path.back()).x < 0.01) {
    path.erase(path.end() - 2);
  }
}

}  // namespace

Follower::Drive Follower::go_on(Drive drive, const RouteAround& around, const Seen& seen) {
  progress(around);
  PathAhead ahead = manner_.by_places ? released_places(*route_, around) : path_ahead(config_, *route_, around);
  if (turn_ || turns_first(around, is_still(seen.speed_m_s))) return turn_on_the_spot(around);
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
  drive.along = Ahead{ahead.robot_from_path,
                      0.0,
                      ahead.reaches_end && ends_at_goal(*route_),
                      std::min(sure_m_s, limit_m_s),
                      seen.speed_m_s,
                      config_.follow.aside_m,
                      !std::holds_alternative<AlongPath>(seen.estimate->place_from_robot),
                      seen.elapsed};
  return manner_.by_places ? by_places(std::move(drive), ahead, around, seen)
                           : by_path(std::move(drive), ahead, around, seen);
}

bool Follower::turns_first(const RouteAround& around, bool stands) {
  constexpr double kDriven_rad = 0.8;  // what lies further aside is turned to
  constexpr double kAtPlace_m = 0.1;
  if (!manner_.both_ways || !std::exchange(faces_anew_, false) || !stands) return false;
  const RoutePose& here = around.poses[around.nearest];
  const bool is_there = here.robot_from_place.translation().norm() <= kAtPlace_m;
  const double aside_rad = is_there ? heading_on(here) : here.robot_from_place.heading;
  if (std::abs(aside_rad) <= kDriven_rad) return false;
  turn_ = Turn{here.index, is_there};
  return true;
}

Follower::Drive Follower::at_end_of_path(const PathAhead& ahead, const RouteAround& around, const Seen& seen) {
  if (ahead.turn_to_rad) {
    turn_ = Turn{ahead.turn_reaches, true};
    return turn_on_the_spot(around);
  }
  at_end_ = true;
  return end_of_path(around, *seen.estimate);
}

Follower::Drive Follower::by_path(Drive drive, const PathAhead& ahead, const RouteAround& around, const Seen& seen) {
  Result<Spline> path = Spline::through(drive.along->robot_from_path);
  if (!path) {
    standing(drive.navigated, Following::stopped, "route_makes_no_path");
    drive.along.reset();
    return drive;
  }
  const double along_m = path->nearest({0.0, 0.0}, -1.0, path->length_m() + 1.0);
  drive.along->to_end_m = path->length_m() - along_m;
  const bool stands_at_end = drive.along->to_end_m <= config_.tracker.stop_at_m && is_still(seen.speed_m_s);
  if (ahead.reaches_end && stands_at_end) return at_end_of_path(ahead, around, seen);
  if (!ahead.reaches_end && path->length_m() <= 0.0) {
    // Nothing ahead of it on this route can be bent into: another route may lead there.
    standing(drive.navigated, Following::failed, "route_makes_no_path");
    drive.along.reset();
    return drive;
  }
  if (!ahead.reaches_end && stands_at_end) {
    // All that comes next on this route lies beside or behind the robot.
    stuck_ = stood_;
    drive.along.reset();
    return stuck(std::move(drive), seen, "route_makes_no_path");
  }
  drive.path = std::move(*path);
  return drive;
}

Follower::Drive Follower::by_places(Drive drive, const PathAhead& ahead, const RouteAround& around,
                                    const Seen& seen) {
  constexpr double kThere_m = 0.15;  // from where it stands the rest is driven as everybody drives it
  drive.along->to_end_m = way_left_m(drive.along->robot_from_path);
  const bool is_there = drive.along->robot_from_path.back().translation().norm() <= kThere_m;
  if (ahead.reaches_end && is_there && is_still(seen.speed_m_s)) return at_end_of_path(ahead, around, seen);
  return drive;
}

Follower::Drive Follower::turn_on_the_spot(const RouteAround& around) {
  constexpr double turned_rad = 0.05;
  Drive drive;
  const auto target = std::find_if(around.poses.begin(), around.poses.end(),
                                   [&](const RoutePose& pose) { return pose.index == turn_->place; });
  if (target != around.poses.end()) {
    const double heading = turn_->reaches ? heading_on(*target) : target->robot_from_place.heading;
    drive.navigated.command = tracker_.turn(config_.tracker, heading, turned_rad);
  }
  if (drive.navigated.command.angular_rad_s == 0.0) {
    if (turn_->reaches) at_ = std::max(at_.value_or(0), turn_->place);
    turn_.reset();
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
  const Arrival::Out out =
      arrival_.step(config_.follow, config_.tracker, around.robot_from_end, estimate.blind_m <= fresh_m);
  arrived_ = out.arrived;
  drive.navigated.command = out.command;
  if (!out.reason.empty()) {
    standing(drive.navigated, Following::failed, out.reason);
    return drive;
  }
  drive.navigated.following = arrived_ ? Following::arrived : Following::driving;
  return drive;
}

}  // namespace weft::agents
