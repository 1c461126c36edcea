#include <algorithm>
#include <limits>
#include <utility>

#include "server/traffic/traffic.hpp"

/// Decides how far a route can be released.
namespace weft::server {
namespace {

/// Sets the room that is left before a robot in the way: it may have to go back to a place behind it to set off, and
/// two robots must not each wait for the other's first step.
constexpr double kRoomToSetOff_m = 0.5;
/// Bounds how far beyond its own size a robot may drive and not count as on its way.
constexpr double kStandsWithin_m = 1.0;
/// Bound from below by how much a robot has to get away from what somebody else holds, that it may move at all: who
/// drives along that is no farther off, whatever it comes to lie beside it.
constexpr double kAway_m = 0.15;
constexpr double kAwayShare = 1.0 / 3.0;  ///< of the way that it drives
/// Bounds how much nearer a place may lie than the one before and still count as no nearer.
constexpr double kSame_m = 1e-6;

double length_m(const storage::PutOccupancy& held) {
  double length = 0.0;
  for (std::uint32_t i = held.from; i < held.to; ++i) length += distance_m(held.held.relations[i]);
  return length;
}

/// Leaves room to set off before the robot in the way. The place where a route begins is the robot's in any case.
void leave_room(const Route& route, std::uint32_t from, Traffic::Way& way) {
  double room_m = 0.0;
  while (way.through.value_or(0) > 0 && room_m < kRoomToSetOff_m) {
    room_m += distance_m(route.relations[*way.through - 1]);
    way.through = *way.through > from ? std::optional(*way.through - 1) : std::nullopt;
  }
}

}  // namespace

std::optional<RobotId> Traffic::other_that_drives(const RobotId& robot) const {
  const auto found = std::find_if(holders_.begin(), holders_.end(), [&](const auto& entry) {
    const auto& [other, holder] = entry;
    return other != robot && length_m(holder.occupancy) > 2 * holder.footprint_m + kStandsWithin_m;
  });
  if (found == holders_.end()) return std::nullopt;
  return found->first;
}

/// Returns what keeps the robot where it is wherever it is going.
Traffic::Way Traffic::held_back(const RobotId& robot) {
  Way way;
  if (!holdings_.are_others_laid(robot)) way.end = Way::End::not_laid;
  if (way.end != Way::End::free || context_.config.unjoined != Unjoined::one_drives || by_part().size() < 2) {
    return way;
  }
  if (const std::optional<RobotId> driver = other_that_drives(robot)) {
    way.end = Way::End::one_at_once;
    way.blocked_by = {*driver};
  }
  return way;
}

Traffic::Way Traffic::way(const Route& route, std::uint32_t from, const Stops* stops) {
  watches_.forget(route.robot);
  Way way = held_back(route.robot);
  if (way.end == Way::End::free && !move_away(route, from, way)) go_on(route, from, stops, way);
  watch(route.robot, way);
  return way;
}

/// Looks along the route up to the first place that the robot cannot have.
void Traffic::go_on(const Route& route, std::uint32_t from, const Stops* stops, Way& way) {
  const auto end = static_cast<std::uint32_t>(route.places.size() - 1);
  const std::uint32_t last = stops == nullptr ? end : std::min(stops->back(), end);
  const std::vector<Touched> wanted = touched_by(route, from, last, holder(route.robot).footprint_m);
  for (std::uint32_t i = 0; i < wanted.size() && way.end == Way::End::free; ++i) {
    const LocatedPlace here = proximity_.locate(map(), wanted[i]);
    way.blocked_by = holders_near(here, route.robot);
    if (!way.blocked_by.empty()) way.end = Way::End::held;
    if (!here.is_laid) way.end = Way::End::not_laid;
    if (way.end == Way::End::free) {
      way.through = from + i;
    } else {
      way.needs = wanted[i];
    }
  }
  if (stops != nullptr) {
    end_at_stop(route, wanted, from, *stops, way);
  } else if (way.end != Way::End::free) {
    leave_room(route, from, way);
  }
}

/// Ends the release at the last stop that can be had, and that leaves room to set off to robots that stand; the end
/// of the route is as near to them as it is.
void Traffic::end_at_stop(const Route& route, const std::vector<Touched>& wanted, std::uint32_t from,
                          const Stops& stops, Way& way) {
  const std::optional<std::uint32_t> farthest = std::exchange(way.through, std::nullopt);
  if (!farthest) return;
  auto stop = std::upper_bound(stops.begin(), stops.end(), *farthest);
  while (stop != stops.begin() && *std::prev(stop) >= from && !way.through) {
    --stop;
    const bool is_end = *stop + 1 == route.places.size();
    Touched there = wanted[*stop - from];
    there.reach_m += kRoomToSetOff_m;
    const std::set<RobotId> crowded = is_end ? std::set<RobotId>() : standing_near(route.robot, there);
    if (crowded.empty()) {
      way.through = *stop;
    } else {
      way.end = Way::End::held;
      way.blocked_by = crowded;
      way.needs = there;
    }
  }
}

/// Returns the robots that stand there and never had a route: in full rings there is no more room before the others.
std::set<RobotId> Traffic::standing_near(const RobotId& robot, const Touched& there) {
  std::set<RobotId> near = holders_near(proximity_.locate(map(), there), robot);
  std::erase_if(near, [this](const RobotId& other) { return holders_.at(other).occupancy.held.id; });
  return near;
}

/// Lets a robot out of what somebody else holds, when it stands in there: by places of its route that do not come
/// nearer to that, and lie farther off in the end; a piece at a time. A robot beside its place would first drive
/// there, and may come nearer by that. Returns whether there was anything to decide.
bool Traffic::move_away(const Route& route, std::uint32_t from, Way& way) {
  const std::uint32_t stand = from == 0 ? 0 : from - 1;
  Holder& known = holder(route.robot);
  if (from > 0 && !known.moves_away) return false;
  const std::vector<Touched> ahead =
      touched_by(route, stand, static_cast<std::uint32_t>(route.places.size() - 1), known.footprint_m);
  const LocatedPlace here = proximity_.locate(map(), ahead.front());
  const std::set<RobotId> inside = here.is_laid ? holders_near(here, route.robot) : std::set<RobotId>();
  known.moves_away = !inside.empty();
  if (inside.empty()) return false;
  way.end = Way::End::held;
  way.blocked_by = inside;
  way.needs = ahead.front();
  const bool is_there = from == 0 ? known.beside_m <= kLeastSlack_m : has_driven(known, stand);
  if (is_there) way.through = away_through(route, stand, ahead, inside);
  way.is_away = way.through.has_value();
  return true;
}

/// Returns whether the robot has come to the end of what it was given.
bool Traffic::has_driven(const Holder& known, std::uint32_t stand) {
  const storage::PutOccupancy& held = known.occupancy;
  if (held.held.places.empty() || held.to != stand) return false;
  return length_m(held) <= known.footprint_m + kLeastSlack_m;
}

std::optional<std::uint32_t> Traffic::away_through(const Route& route, std::uint32_t stand,
                                                   const std::vector<Touched>& ahead,
                                                   const std::set<RobotId>& inside) {
  const double piece_m = 2 * (holder(route.robot).footprint_m + kLeastSlack_m) + kMargin_m;
  const std::vector<double> begin_m = clearances_m(inside, proximity_.locate(map(), ahead.front()));
  std::vector<double> before_m = begin_m;
  std::optional<std::uint32_t> through;
  double driven_m = 0.0;
  for (std::uint32_t i = 1; i < ahead.size() && driven_m < piece_m; ++i) {
    const LocatedPlace next = proximity_.locate(map(), ahead[i]);
    const std::set<RobotId> holders = holders_near(next, route.robot);
    const std::vector<double> now_m = clearances_m(inside, next);
    const auto rises_by = [&](const std::vector<double>& than, double by_m) {
      return std::equal(now_m.begin(), now_m.end(), than.begin(),
                        [by_m](double a, double b) { return a >= b + by_m; });
    };
    const bool is_other = !std::includes(inside.begin(), inside.end(), holders.begin(), holders.end());
    if (!next.is_laid || is_other || !rises_by(before_m, -kSame_m)) break;
    driven_m += distance_m(route.relations[stand + i - 1]);
    before_m = now_m;
    if (rises_by(begin_m, std::max(kAway_m, kAwayShare * driven_m))) through = stand + i;
  }
  return through;
}

/// Returns how near each robot's holding may be to `here`, and how near it most probably is: a clearance of nothing,
/// where that is unsure, hides that the robot comes nearer.
std::vector<double> Traffic::clearances_m(const std::set<RobotId>& robots, const LocatedPlace& here) const {
  std::vector<double> all_m;
  for (const RobotId& robot : robots) {
    constexpr double far_m = std::numeric_limits<double>::max();
    all_m.push_back(holdings_.clearance_m(proximity_, robot, here).value_or(far_m));
    all_m.push_back(holdings_.distance_m(robot, here).value_or(far_m));
  }
  return all_m;
}

/// Notes when the release is worth another look.
void Traffic::watch(const RobotId& robot, const Way& way) {
  switch (way.end) {
    case Way::End::free:
    case Way::End::turn:
      break;
    case Way::End::held:
      watches_.watch(robot, way.needs, way.blocked_by);
      break;
    case Way::End::not_laid:
      watches_.watch_map(robot);
      break;
    case Way::End::one_at_once:
      watches_.watch_everybody(robot);
      break;
  }
}

std::set<RobotId> Traffic::near(const PlaceId& place, const RobotId& except) {
  if (!map().is_in(place)) return {};
  const auto known = holders_.find(except);
  const double footprint_m = known == holders_.end() ? 0.0 : known->second.footprint_m;
  return holders_near(proximity_.locate(map(), {.place = place, .reach_m = footprint_m + kLeastSlack_m}), except);
}

std::optional<Touched> Traffic::first_held_by(const RobotId& by, const Route& route, std::uint32_t from) {
  if (from >= route.places.size()) return std::nullopt;
  const auto end = static_cast<std::uint32_t>(route.places.size() - 1);
  const std::vector<Touched> wanted = touched_by(route, from, end, holder(route.robot).footprint_m);
  std::optional<Touched> first;
  for (const Touched& place : wanted) {
    const std::set<RobotId> holders = holders_near(proximity_.locate(map(), place), route.robot);
    if (!holders.contains(by)) continue;
    if (holders.size() == 1) return place;
    if (!first) first = place;
  }
  return first;
}

std::set<RobotId> Traffic::holders_of(const RobotId& robot, const Way& way) {
  if (way.end != Way::End::held) return way.blocked_by;
  return holders_near(proximity_.locate(map(), way.needs), robot);
}

}  // namespace weft::server
