#include "server/traffic/traffic.hpp"

#include <algorithm>
#include <utility>

namespace weft::server {
namespace {

/// Sets the footprint's radius that is assumed until a robot has described itself. Larger than usual robots, so that
/// a restart of the server frees nothing that may still be touched.
constexpr double kUnknownFootprint_m = 0.6;
/// Bounds the move of a nearest place within which a standing robot is still at the place it was at.
constexpr double kSameStand_m = 0.2;

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
  for (const auto& [robot, held] : holders_) hold(robot, held);
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
  holdings_.refresh_all(map(), proximity_);
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
  if (proximity_.grow_radius(2 * (radius_m + 2 * kLeastSlack_m) + kMargin_m)) {
    holdings_.refresh_all(map(), proximity_);
  }
  hold(robot, known);
  watches_.wake_all();
}

std::set<RobotId> Traffic::holders_near(const LocatedPlace& here, const RobotId& except) {
  return holdings_.near(map(), proximity_, here, except);
}

/// Takes in that the robot holds something else than before, and wakes those who wait for what it has given up.
void Traffic::hold(const RobotId& robot, const Holder& holder) {
  holdings_.put(map(), proximity_, robot, touched(holder));
  for (const Watches::Watch& watch : watches_.on(robot)) {
    const LocatedPlace needs = proximity_.locate(map(), watch.needs);
    if (!holdings_.holds_near(map(), proximity_, robot, needs)) watches_.wake(watch.waiter);
  }
  if (holder.moves_away) watches_.wake(robot);
  watches_.wake_those_for_everybody();
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
    const bool is_other = known.occupancy.held.id != occupancy.held.id;
    known.occupancy = occupancy;
    known.is_stored = true;
    if (occupancy.held.id) {
      known.cleared_at.reset();
      known.intruding.reset();  // it holds where it stands by its route
    }
    if (is_other) ++parts_version_;
    hold(occupancy.robot, known);
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
  hold(robot, known);
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
  hold(state.header.sender, known);
}

void Traffic::stands(const msg::RobotState& state, Now now) {
  if (!state.localised || !state.place) return;
  Holder& known = holder(state.header.sender);
  known.beside_m = distance_m(state.place_from_robot);
  follow_lead(known, state);
  if (known.cleared_at == state.place) return;
  if (!known.intruding && is_there_still(known, state)) return;
  // A place that was taught a moment ago and is not here yet cannot be held.
  if (context_.snapshots.current().place(state.place) == nullptr) return;
  known.cleared_at.reset();
  settle(state.header.sender, known, state, now);
}

void Traffic::settle(const RobotId& robot, Holder& known, const msg::RobotState& state, Now now) {
  const Touched here = standing(state, known.footprint_m);
  const std::set<RobotId> others = holders_near(proximity_.locate(map(), here), robot);
  if (others.empty() || !known.intruding || known.intruding->place != here.place) {
    // Stored also where somebody else holds that: nobody is released towards it, after a restart neither.
    const Revision revision = context_.snapshots.current().revision();
    if (!store(robot, known, standing_at(robot, state.place, revision), now)) return;
    ++parts_version_;
  }
  if (others.empty()) {
    known.intruding.reset();
    hold(robot, known);
    drop_history();
    return;
  }
  if (!known.intruding) {
    context_.writer.note({.at = {},
                          .kind = "traffic.too_close",
                          .robot = robot,
                          .goal = {},
                          .cause = "it stands at " + to_string(state.place) + ", within what robot " +
                                   to_string(*others.begin()) + " holds",
                          .who = "server"},
                         now);
  }
  known.intruding = here;
  hold(robot, known);
}

void Traffic::stands_without_route(const msg::RobotState& state) {
  if (!state.localised || context_.snapshots.current().place(state.place) == nullptr) return;
  Holder& known = holder(state.header.sender);
  known.beside_m = distance_m(state.place_from_robot);
  const Touched here = standing(state, known.footprint_m);
  if (known.intruding && known.intruding->place == here.place && known.intruding->reach_m >= here.reach_m) return;
  known.intruding = here;
  hold(state.header.sender, known);
}

void Traffic::follows(const RobotId& robot) {
  const auto found = holders_.find(robot);
  if (found == holders_.end() || !found->second.intruding) return;
  found->second.intruding.reset();
  hold(robot, found->second);
  drop_history();
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
  ++parts_version_;
  hold(robot, known);
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
  ++parts_version_;
  hold(robot, known);
  drop_history();
  return "its route is free; " + stays;
}

std::vector<RobotId> Traffic::holding() const {
  std::vector<RobotId> robots;
  for (const auto& [robot, holder] : holders_) {
    if (!holder.occupancy.held.places.empty()) robots.push_back(robot);
  }
  return robots;
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
