#include "agents/navigation/route_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "agents/navigation/route_facing.hpp"
#include "agents/navigation/spots.hpp"
#include "core/network/search.hpp"

namespace weft::agents {

namespace {

constexpr double gentle_rad = 0.2;  // how steep a bend is driven where there is a choice

/// Returns whether `next` can be driven to from `from`, both headings kept, without a sharp bend: ahead, and no
/// steeper to the side than the turn itself explains (an arc's chord lies half way between its headings). In front of
/// a stitch the next places are tried instead.
bool drivable(const Pose2& from, const Pose2& next, double steepest_rad) {
  constexpr double least_ahead_m = 0.04;
  const Pose2 step = from.inverse() * next;
  if (step.x < least_ahead_m) return false;
  return std::abs(wrap_angle(std::atan2(step.y, step.x) - 0.5 * step.heading)) <= steepest_rad;
}

/// Returns whether a robot at `from` can get onto a way that leads straight on through `onto`.
bool merges(const StitchConfig& config, const Pose2& from, const Pose2& onto) {
  return drivable(from, onto * Pose2{config.merge_m, 0.0, 0.0}, gentle_rad);
}

void append_end(std::vector<Pose2>& path, const Pose2& end, double steepest_rad) {
  while (path.size() > 1 && !drivable(path.back(), end, steepest_rad)) path.pop_back();
  constexpr double least_m = 0.005;
  if (!path.empty() && (path.back().translation() - end.translation()).norm() < least_m) path.pop_back();
  // Beyond the end, or beside it with nothing left to drive on: the end alone says where to stand.
  if (path.size() == 1 && !drivable(path.back(), end, steepest_rad)) path.pop_back();
  path.push_back(end);
}

}  // namespace

Pose2 laid_out(const Relation& a_from_b) {
  if (const auto* const along = std::get_if<AlongPath>(&a_from_b)) {
    return se2_exp({along->distance_m, 0.0, along->heading_shift_rad});
  }
  return planar(a_from_b);
}

bool can_cross(const StitchConfig& config, const Relation& a_from_b) {
  if (distance_m(a_from_b) > config.drivable_m || std::abs(heading_rad(a_from_b)) > config.drivable_rad) return false;
  const Pose2 a;
  const Pose2 b = laid_out(a_from_b);
  return merges(config, a, b) && merges(config, b, a);
}

namespace {

constexpr std::uint32_t around_at = 10;  // places of a route before and after the last one passed

std::uint32_t apart(std::uint32_t a, std::uint32_t b) {
  return a > b ? a - b : b - a;
}

/// Returns the index of the believed place itself that is nearest to `from`; a route may come by a place twice.
std::optional<std::uint32_t> own_index(const Route& route, const PlaceId& place, std::uint32_t from) {
  std::optional<std::uint32_t> own;
  for (std::uint32_t i = 0; i < route.places.size(); ++i) {
    if (route.places[i] == place && (!own || apart(i, from) < apart(*own, from))) own = i;
  }
  return own;
}

/// Returns the place of route[first .. end) that is nearest to the robot, as the window joins it.
std::optional<Joint> nearest_joined(const NavigationConfig& config, const Window& window, const Route& route,
                                    const Estimate& estimate, std::uint32_t first, std::uint32_t end) {
  std::map<PlaceId, std::uint32_t> index_of;
  for (std::uint32_t i = end; i-- > first;) index_of[route.places[i]] = i;
  constexpr std::uint32_t cap = 2000;
  std::optional<Joint> best;
  double nearest = 0.0;
  for (const Reached& reached : breadth_first(window, estimate.place, config.locate.most_hops, cap)) {
    const auto found = index_of.find(reached.id);
    if (found == index_of.end()) continue;
    const double away = norm(compose(inverse(estimate.place_from_robot), reached.centre_from_place));
    if (best && away >= nearest) continue;
    best = Joint{found->second, reached.centre_from_place};
    nearest = away;
  }
  return best;
}

/// Returns how far a place is from the robot, metres, of which its heading is a part.
double off(const RoutePose& pose) {
  constexpr double lever_m = 0.3;
  return std::hypot(pose.robot_from_place.translation().norm(), lever_m * pose.robot_from_place.heading);
}

/// Returns whether the robot may be at a place, having passed the one at `at`.
bool may_be_at(const RoutePose& pose, std::optional<std::uint32_t> at, std::uint32_t last) {
  if (at && (pose.index < *at || pose.index > *at + around_at)) return false;
  return pose.index <= last;
}

/// Faces the way that is driven, by which another place may be the nearest.
void face(RouteAround& around, std::optional<std::uint32_t> at, std::uint32_t last) {
  face_travel(around.poses);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < around.poses.size(); ++i) {
    if (!may_be_at(around.poses[i], at, last) || off(around.poses[i]) >= nearest) continue;
    nearest = off(around.poses[i]);
    around.nearest = i;
  }
}

}  // namespace

std::optional<Joint> joint(const NavigationConfig& config, const Window& window, const Route& route,
                           const Estimate& estimate, std::uint32_t from) {
  const auto all = static_cast<std::uint32_t>(route.places.size());
  const std::optional<std::uint32_t> own = own_index(route, estimate.place, from);
  // What has just been passed is joined to the robot, too, where the map does not say what comes next.
  if (!own) return nearest_joined(config, window, route, estimate, from > around_at ? from - around_at : 0, all);
  if (apart(*own, from) <= around_at) return Joint{*own, Metric2{}};
  // A route round a loop: the place may be on it much later, and beside where the route is now.
  const std::optional<Joint> beside =
      nearest_joined(config, window, route, estimate, std::min(from, all), std::min(from + around_at, all));
  const bool is_near = beside && norm(compose(inverse(estimate.place_from_robot), beside->believed_from_route)) <=
                                     config.follow.join_m;
  return is_near ? *beside : Joint{*own, Metric2{}};
}

RouteAround around(const NavigationConfig& config, const Route& route, const Joint& joint,
                   const Relation& believed_from_robot, std::optional<std::uint32_t> at, bool both_ways) {
  const auto last = std::min(route.released, static_cast<std::uint32_t>(route.places.size() - 1));
  const std::uint32_t anchor = std::min(joint.index, static_cast<std::uint32_t>(route.places.size() - 1));
  std::vector<RoutePose> back{
      {anchor, laid_out(believed_from_robot).inverse() * laid_out(joint.believed_from_route)}};
  while (back.back().index > 0 && anchor - back.back().index < around_at) {
    const std::uint32_t index = back.back().index - 1;
    back.push_back({index, back.back().robot_from_place * laid_out(route.relations[index]).inverse()});
  }
  RouteAround result;
  result.poses.assign(back.rbegin(), back.rend());
  // As far as the segment reaches beyond the nearest place.
  double nearest = std::numeric_limits<double>::infinity();
  double since_nearest_m = 0.0;
  const auto weigh = [&](std::size_t position) {
    const RoutePose& pose = result.poses[position];
    if (!may_be_at(pose, at, last)) return;
    const double apart = off(pose);
    if (apart >= nearest) return;
    nearest = apart;
    result.nearest = position;
    since_nearest_m = 0.0;
  };
  for (std::size_t i = 0; i < result.poses.size(); ++i) weigh(i);
  for (std::uint32_t index = anchor; index < last && since_nearest_m < config.follow.segment_m; ++index) {
    const Pose2 hop = laid_out(route.relations[index]);
    result.poses.push_back({index + 1, result.poses.back().robot_from_place * hop});
    since_nearest_m += hop.translation().norm();
    weigh(result.poses.size() - 1);
  }
  while (result.poses.size() > 1 && result.poses.back().index > last) result.poses.pop_back();
  result.nearest = std::min(result.nearest, result.poses.size() - 1);
  result.robot_from_end = result.poses.back().robot_from_place;
  if (both_ways) face(result, at, last);
  return result;
}

namespace {

PathAhead path_no_steeper(const NavigationConfig& config, const Route& route, const RouteAround& around,
                          double steepest_rad) {
  const std::vector<RoutePose>& poses = around.poses;
  PathAhead ahead;
  const std::optional<Spot> spot = next_spot(around);
  const std::size_t end = spot ? spot->first : poses.size() - 1;
  // From some way behind: a stitch that the robot is just crossing has to be smoothed from the same place as before.
  constexpr double behind_m = 0.8;
  std::size_t first = around.nearest;
  const auto turns_at = [&](std::size_t i) {
    return poses[i].turn_rad != 0.0 || on_the_spot(poses[i - 1], poses[i]);
  };
  for (double back_m = 0.0; first > 0 && back_m < behind_m && !turns_at(first); --first) {
    back_m += (poses[first].robot_from_place.translation() - poses[first - 1].robot_from_place.translation()).norm();
  }
  first = std::min(first, end);

  std::vector<Pose2> path{first < end ? robot_from_way_on(poses[first]) : poses[first].robot_from_place};
  double length_m = 0.0;
  for (std::size_t i = first + 1; i < end; ++i) {
    const Pose2 next = robot_from_way_on(poses[i]);
    if (!drivable(path.back(), next, steepest_rad)) continue;
    length_m += (next.translation() - path.back().translation()).norm();
    path.push_back(next);
    if (i > around.nearest && length_m > config.follow.segment_m + behind_m) break;
  }
  const bool cut = length_m > config.follow.segment_m + behind_m;
  const auto last = std::min(route.released, static_cast<std::uint32_t>(route.places.size() - 1));
  if (!cut && first < end) append_end(path, poses[end].robot_from_place, steepest_rad);
  ahead.reaches_end = !cut && (end < poses.size() - 1 || poses[end].index == last);
  if (!cut && spot) {
    ahead.turn_to_rad = heading_on(poses[spot->last]);
    ahead.turn_reaches = poses[spot->last].index;
  }
  ahead.robot_from_path = std::move(path);
  return ahead;
}

}  // namespace

PathAhead path_ahead(const NavigationConfig& config, const Route& route, const RouteAround& around) {
  // Where a way leads off beside the robot no gentle bend may lead there: then a steeper one, slower, is better than
  // none.
  PathAhead ahead;
  for (const double steepest_rad : {gentle_rad, 2.0 * gentle_rad, 4.0 * gentle_rad}) {
    ahead = path_no_steeper(config, route, around, steepest_rad);
    if (ahead.reaches_end || ahead.robot_from_path.size() > 1) break;
  }
  return ahead;
}

}  // namespace weft::agents
