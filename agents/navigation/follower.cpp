#include "agents/navigation/follower.hpp"

#include <algorithm>
#include <utility>

#include "agents/navigation/released_places.hpp"
#include "agents/navigation/ways.hpp"

namespace weft::agents {

namespace {

std::uint32_t end_of(const Route& route) {
  return std::min(route.released, static_cast<std::uint32_t>(route.places.size() - 1));
}

/// Returns how far a robot may be from its route: one that steers itself wherever it may have steered to, and where
/// it gets a new route that begins at one end of the shortcut that it is driving.
double farthest_m(const FollowConfig& follow, bool steers_itself) {
  constexpr double believed_off_m = 0.2;
  const double away_m = std::max(follow.aside_m, 0.5 * longest_shortcut_m) + believed_off_m;
  return steers_itself ? std::max(follow.join_m, away_m) : follow.join_m;
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
    turn_.reset();
    faces_anew_ = true;
  }
  if (!at_ && from > 0) at_ = from;
  route_ = route;
  arrived_ = false;
  at_end_ = false;
  arrival_.reset();
}

void Follower::stop() {
  *this = Follower(config_, manner_);
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

void Follower::stuck(Navigated& navigated, Duration elapsed, std::string_view reason) {
  stuck_ += elapsed;
  const bool gives_up = seconds(stuck_) > config_.follow.give_up_s;
  standing(navigated, gives_up ? Following::failed : Following::stopped, reason);
}

Follower::Drive Follower::stuck(Drive drive, const Seen& seen, std::string_view reason) {
  stuck(drive.navigated, seen.elapsed, reason);
  return drive;
}

void Follower::steered(const Steering& steering, Duration elapsed, Navigated& navigated) {
  if (steering) {
    navigated.command = *steering;
    // Standing without a reason neither ends a stop nor is one.
    if (manner_.by_places && *steering == Twist{}) stuck_ = stood_;
    return;
  }
  stuck_ = stood_;
  stuck(navigated, elapsed, steering.error().reason);
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
    faces_anew_ = true;
    standing(drive.navigated, Following::stopped, seen.lost ? "lost" : "not_localised");
    return drive;
  }
  const std::optional<Joint> found = joint(config_, seen.window, *route_, *seen.estimate, at_.value_or(0));
  if (!found) return stuck(std::move(drive), seen, "route_not_joined");
  const RouteAround around =
      agents::around(config_, *route_, *found, seen.estimate->place_from_robot, at_, manner_.both_ways);
  // Its route may come by where it stands once more, beyond what is released.
  if (around.poses.back().index > end_of(*route_)) return stuck(std::move(drive), seen, "beyond_release");
  // Shortcuts are long: half way the next place is far off.
  const double away_m = manner_.both_ways ? away_from_way_m(around)
                                          : around.poses[around.nearest].robot_from_place.translation().norm();
  if (away_m > farthest_m(config_.follow, manner_.by_places)) return stuck(std::move(drive), seen, "off_route");
  stood_ = std::exchange(stuck_, {});
  return go_on(std::move(drive), around, seen);
}

Steering Follower::steer(const Ahead& ahead, const Spline& path) {
  return tracker_
      .track(config_.tracker, path, ahead.speed_limit_m_s, {ahead.speed_m_s, ahead.knows_aside, ahead.elapsed})
      .command;
}

}  // namespace weft::agents
