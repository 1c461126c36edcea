#include "server/traffic/traffic.hpp"

#include <algorithm>
#include <utility>

namespace weft::server {
namespace {

/// Is reckoned with until a robot has described itself. Larger than usual robots, so that a restart gives nothing
/// away.
constexpr double kUnknownFootprint_m = 0.6;
/// Bounds the move of a nearest place within which a standing robot is still at the place it was at.
constexpr double kSameStand_m = 0.2;
/// Is left free before a robot in the way: it may have to go back to a place behind it to set off, and two robots
/// must not each wait for the other's first step.
constexpr double kRoomToSetOff_m = 0.5;

storage::PutOccupancy standing_at(const RobotId& robot, const PlaceId& place, Revision revision) {
  storage::PutOccupancy occupancy;
  occupancy.robot = robot;
  occupancy.held.made_of = revision;
  occupancy.held.robot = robot;
  occupancy.held.places = {place};
  return occupancy;
}

storage::PutOccupancy nothing_held(const RobotId& robot) {
  storage::PutOccupancy occupancy;
  occupancy.robot = robot;
  return occupancy;
}

/// Returns what a standing robot touches: around its place, further off than the usual slack only if it says so.
Touched standing(const msg::RobotState& state, double footprint_m) {
  return {.place = state.place, .reach_m = footprint_m + std::max(kLeastSlack_m, distance_m(state.place_from_robot))};
}

}  // namespace

Traffic::Traffic(Context& context, std::map<RobotId, storage::PutOccupancy> stored, Now now)
    : context_(context),
      proximity_(2 * (kUnknownFootprint_m + 2 * kLeastSlack_m) + kMargin_m),
      next_piece_(now.steady) {
  for (auto& entry : stored) holder(entry.first).occupancy = std::move(entry.second);
  load_history(now);
  proximity_.layout().lay(context_.snapshots.shared_current());
  lay_out_at_once();
}

/// Loads the maps of stretches that were given out before an edit of the map, and held when the server ended.
void Traffic::load_history(Now now) {
  for (const auto& [robot, holder] : holders_) {
    const Route& held = holder.occupancy.held;
    const bool is_known = std::all_of(held.places.begin(), held.places.end(),
                                      [this](const PlaceId& place) { return map().has(place); });
    if (is_known) continue;
    Result<Snapshot> then = context_.store.snapshot_at(held.made_of, context_.snapshots.current());
    if (then) {
      history_.push_back(std::make_shared<const Snapshot>(*std::move(then)));
      continue;
    }
    context_.writer.note({.at = {},
                          .kind = "traffic.ground_unknown",
                          .robot = robot,
                          .goal = {},
                          .cause = "it holds places that are no more, and what lay around them is not known (" +
                                   then.error().message + "): look where it stands, then weft robot clear",
                          .who = "server"},
                         now);
  }
}

std::set<PlaceId> Traffic::held_places() const {
  std::set<PlaceId> places;
  for (const auto& [robot, holder] : holders_) {
    for (const Touched& one : touched(holder)) places.insert(one.place);
  }
  return places;
}

bool Traffic::holds_what_is_out() const {
  const std::set<PlaceId> held = held_places();
  return std::any_of(held.begin(), held.end(),
                     [this](const PlaceId& place) { return context_.snapshots.current().place(place) == nullptr; });
}

void Traffic::drop_history() {
  if (history_.empty() || holds_what_is_out()) return;
  history_.clear();
  proximity_.forget();
}

Traffic::Holder& Traffic::holder(const RobotId& robot) {
  const auto [at, is_new] = holders_.try_emplace(robot);
  if (is_new) {
    at->second.occupancy = nothing_held(robot);
    at->second.footprint_m = kUnknownFootprint_m;
  }
  return at->second;
}

std::vector<Touched> Traffic::touched(const Holder& holder) const {
  std::vector<Touched> all = touched_by(holder.occupancy, holder.footprint_m);
  if (holder.intruding) all.push_back(*holder.intruding);
  if (holder.led_on) all.push_back(*holder.led_on);
  return all;
}

void Traffic::set_footprint(const RobotId& robot, double radius_m) {
  Holder& known = holder(robot);
  if (known.footprint_m == radius_m) return;
  known.footprint_m = radius_m;
  proximity_.grow_radius(2 * (radius_m + 2 * kLeastSlack_m) + kMargin_m);
  ++version_;
}

std::vector<Traffic::Other> Traffic::others_of(const RobotId& robot) {
  std::vector<Other> others;
  for (const auto& [other, holder] : holders_) {
    if (other == robot) continue;
    others.push_back({other, proximity_.locate(map(), touched(holder))});
  }
  return others;
}

std::optional<RobotId> Traffic::holder_near(const std::vector<Other>& others, const LocatedPlace& here) {
  const auto found = std::find_if(others.begin(), others.end(),
                                  [&](const Other& other) { return proximity_.overlap(map(), here, other.touched); });
  if (found == others.end()) return std::nullopt;
  return found->robot;
}

/// Leaves room to set off before the robot in the way. The place where a route begins is the robot's in any case.
void Traffic::leave_room(const Route& route, std::uint32_t from, Way& way) {
  double room_m = 0.0;
  while (way.through && room_m<kRoomToSetOff_m&& * way.through> 0) {
    room_m += distance_m(route.relations[*way.through - 1]);
    way.through = *way.through > from ? std::optional(*way.through - 1) : std::nullopt;
  }
}

/// Returns what keeps the robot where it is wherever it is going.
Traffic::Way Traffic::held_back(const RobotId& robot, const std::vector<Other>& others) {
  const auto is_laid = [](const LocatedPlace& place) { return place.is_laid; };
  const bool are_laid = std::all_of(others.begin(), others.end(), [&](const Other& other) {
    return std::all_of(other.touched.places.begin(), other.touched.places.end(), is_laid);
  });
  if (!are_laid) return {.through = {}, .end = Way::End::not_laid, .blocked_by = {}};
  if (context_.config.unjoined != Unjoined::one_drives || by_part().size() < 2) return {};
  const std::optional<RobotId> driver = other_that_drives(robot);
  return {.through = {}, .end = driver ? Way::End::one_at_once : Way::End::free, .blocked_by = driver};
}

Traffic::Way Traffic::way(const Route& route, std::uint32_t from) {
  const auto last = static_cast<std::uint32_t>(route.places.size() - 1);
  const std::vector<Other> others = others_of(route.robot);
  Way way = held_back(route.robot, others);
  const std::vector<Touched> wanted = touched_by(route, from, last, holder(route.robot).footprint_m);
  for (std::uint32_t i = 0; i < wanted.size() && way.end == Way::End::free; ++i) {
    const LocatedPlace here = proximity_.locate(map(), wanted[i]);
    way.blocked_by = holder_near(others, here);
    if (way.blocked_by) way.end = Way::End::held;
    if (!here.is_laid) way.end = Way::End::not_laid;
    if (way.end == Way::End::free) way.through = from + i;
  }
  if (way.end != Way::End::free) leave_room(route, from, way);
  return way;
}

std::vector<storage::PutOccupancy> Traffic::claim(const Route& route, std::uint32_t from,
                                                  std::uint32_t through) const {
  std::vector<storage::PutOccupancy> changes;
  // What others gave up goes first: at no point does the store hold two that were given and overlap.
  for (const auto& [robot, holder] : holders_) {
    if (!holder.is_stored && robot != route.robot) changes.push_back(holder.occupancy);
  }
  changes.push_back({.robot = route.robot, .held = route, .from = from, .to = through});
  return changes;
}

void Traffic::committed(const std::vector<storage::PutOccupancy>& occupancies) {
  for (const storage::PutOccupancy& occupancy : occupancies) {
    Holder& known = holder(occupancy.robot);
    known.occupancy = occupancy;
    known.is_stored = true;
    if (occupancy.held.id) known.cleared_at.reset();
  }
  drop_history();
}

void Traffic::freed(const RobotId& robot, const RouteId& route, std::uint32_t from) {
  Holder& known = holder(robot);
  storage::PutOccupancy& held = known.occupancy;
  if (held.held.places.empty() || held.held.id != route || from <= held.from) return;
  // The robot stays at least at the end of what it was given.
  held.from = std::min(from, held.to);
  known.is_stored = false;
  ++version_;
  drop_history();
}

bool Traffic::is_there_still(const Holder& known, const msg::RobotState& state) {
  const storage::PutOccupancy& held = known.occupancy;
  if (held.held.places.empty() || held.from != held.to) return false;
  const PlaceId at = held.held.places[held.from];
  if (at == state.place) return true;
  // Between two places, or two runs over one floor, the nearest one flickers.
  const std::optional<double> farthest_m = proximity_.farthest_m(map(), at, state.place);
  return farthest_m && *farthest_m + distance_m(state.place_from_robot) <= kSameStand_m;
}

/// Follows a robot that is led along a new run, ahead of what the map has of it; nobody is released to where it may
/// be.
void Traffic::follow_lead(Holder& known, const msg::RobotState& state) {
  std::optional<Touched> led_on;
  if (!map().is_in(state.place)) {
    const storage::PutOccupancy& held = known.occupancy;
    const PlaceId before = held.held.places.empty() ? PlaceId{} : held.held.places[held.to];
    led_on = touched_beyond(context_.snapshots.current(), state.place, before, known.footprint_m);
    if (!led_on->place) led_on.reset();
  }
  const bool is_same = known.led_on && led_on
                           ? known.led_on->place == led_on->place && known.led_on->reach_m == led_on->reach_m
                           : known.led_on.has_value() == led_on.has_value();
  if (is_same) return;
  known.led_on = led_on;
  ++version_;
}

void Traffic::stands(const msg::RobotState& state, Now now) {
  if (!state.localised || !state.place) return;
  Holder& known = holder(state.header.sender);
  follow_lead(known, state);
  if (known.cleared_at == state.place) return;
  if (known.intruding) {
    const bool nothing_new = known.intruding->place == state.place && known.intruding_looked == version_;
    if (nothing_new) return;
  } else if (is_there_still(known, state)) {
    return;
  }
  // A place that was taught a moment ago and is not here yet cannot be held.
  if (context_.snapshots.current().place(state.place) == nullptr) return;
  known.cleared_at.reset();
  settle(state.header.sender, known, state, now);
}

void Traffic::settle(const RobotId& robot, Holder& known, const msg::RobotState& state, Now now) {
  const Touched here = standing(state, known.footprint_m);
  const std::optional<RobotId> other = holder_near(others_of(robot), proximity_.locate(map(), here));
  if (!other || !known.intruding || known.intruding->place != here.place) {
    // Stored also where somebody else holds that: nobody is released towards it, after a restart neither.
    const Revision revision = context_.snapshots.current().revision();
    if (!store(robot, known, standing_at(robot, state.place, revision), now)) return;
    ++version_;
  }
  if (!other) {
    known.intruding.reset();
    drop_history();
    return;
  }
  if (!known.intruding) {
    context_.writer.note(
        {.at = {},
         .kind = "traffic.too_close",
         .robot = robot,
         .goal = {},
         .cause = "it stands at " + to_string(state.place) + ", within what robot " + to_string(*other) + " holds",
         .who = "server"},
        now);
  }
  known.intruding = here;
  known.intruding_looked = version_;
}

bool Traffic::store(const RobotId& robot, Holder& known, storage::PutOccupancy next, Now now) {
  storage::Transaction transaction;
  for (const auto& [other, holder] : holders_) {
    if (!holder.is_stored && other != robot) transaction.changes.emplace_back(holder.occupancy);
  }
  transaction.changes.emplace_back(next);
  if (!context_.writer.commit(std::move(transaction), now)) return false;
  for (auto& [other, holder] : holders_) holder.is_stored = true;
  known.occupancy = std::move(next);
  return true;
}

Result<std::string> Traffic::clear(const RobotId& robot, const std::string& who, Now now) {
  Holder& known = holder(robot);
  if (known.occupancy.held.places.empty() && !known.intruding) return std::string("it held nothing");
  const PlaceId at = known.intruding ? known.intruding->place : known.occupancy.held.places[known.occupancy.from];
  storage::Transaction transaction;
  transaction.changes.emplace_back(nothing_held(robot));
  transaction.changes.emplace_back(storage::PutEvent{{.at = {},
                                                      .kind = "traffic.cleared",
                                                      .robot = robot,
                                                      .goal = {},
                                                      .cause = "from " + to_string(at),
                                                      .who = who}});
  if (const auto done = context_.writer.commit(std::move(transaction), now); !done) {
    return fail(done.error());
  }
  known.occupancy = nothing_held(robot);
  known.is_stored = true;
  known.intruding.reset();
  known.led_on.reset();
  known.cleared_at = at;
  ++version_;
  drop_history();
  return "nothing is held for it any more, from " + to_string(at) + " on";
}

Result<std::string> Traffic::clear_route(const RobotId& robot, const std::optional<PlaceId>& at,
                                         const std::string& who, Now now) {
  Holder& known = holder(robot);
  const storage::PutOccupancy& held = known.occupancy;
  if (held.held.places.empty()) return std::string("it held nothing");
  const PlaceId stands_at = at && map().is_in(*at) ? *at : held.held.places[held.from];
  const std::string stays = to_string(stands_at) +
                            ", where it stands, stays held until it reports from elsewhere, or is silent and is "
                            "cleared again";
  if (!held.held.id) return "it holds no route; " + stays;
  storage::PutOccupancy next = standing_at(robot, stands_at, context_.snapshots.current().revision());
  storage::Transaction transaction;
  transaction.changes.emplace_back(next);
  transaction.changes.emplace_back(storage::PutEvent{{.at = {},
                                                      .kind = "traffic.route_cleared",
                                                      .robot = robot,
                                                      .goal = {},
                                                      .cause = "all but " + to_string(stands_at),
                                                      .who = who}});
  if (const auto done = context_.writer.commit(std::move(transaction), now); !done) {
    return fail(done.error());
  }
  known.occupancy = std::move(next);
  known.is_stored = true;
  ++version_;
  drop_history();
  return "its route is free; " + stays;
}

const storage::PutOccupancy* Traffic::held(const RobotId& robot) const {
  const auto found = holders_.find(robot);
  if (found == holders_.end() || found->second.occupancy.held.places.empty()) return nullptr;
  return &found->second.occupancy;
}

bool Traffic::holds_route(const RobotId& robot, const RouteId& route) const {
  const storage::PutOccupancy* const occupancy = held(robot);
  return occupancy != nullptr && occupancy->held.id == route;
}

}  // namespace weft::server
