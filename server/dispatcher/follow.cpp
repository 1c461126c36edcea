#include <algorithm>
#include <chrono>
#include <utility>

#include "server/base/repeating.hpp"
#include "server/dispatcher/dispatcher.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenLooksAtRoutes = 500ms;
/// Bounds how long an order can be on its way.
constexpr Duration kLongestOnItsWay = 3s;
/// Bounds how long a robot may say that it has no such route before it has lost it.
constexpr Duration kLostAfter = 2s;
/// Bounds how long a robot may say so that is sent its route and has not reported on it since the server knows: it
/// was given back while the server was away, and the robot takes no more orders for it.
constexpr Duration kIgnoredAfter = 10s;
/// Is what a robot says that cannot bend into what lies ahead of it on its route.
constexpr const char* kNoPath = "route_makes_no_path";
/// Is what a robot says that has something in its way and has waited for long.
constexpr const char* kGaveUpBlocked = "blocked";
/// Bounds how long a robot is not asked to make way to where it could not drive.
constexpr Duration kAvoidsFor = 1min;

/// Returns what has a robot forget a route: which, and why. It has no place, and nothing that speaks of places:
/// limits of places that are not in it would have the robot refuse the order.
Route order_to_end(const RobotId& robot, const GoalId& goal, const RouteId& id, std::uint32_t version,
                   std::string reason) {
  Route route;
  route.goal = goal;
  route.id = id;
  route.version = version;
  route.robot = robot;
  route.ended = true;
  route.reason = std::move(reason);
  return route;
}
}  // namespace

/// Returns whether the robot is not at the beginning of its route, where the nearest place may flicker.
static bool stands_elsewhere(const msg::RobotState& state, const Route& route) {
  constexpr std::size_t kBeginning = 3;
  if (!state.localised || !state.place) return false;
  const auto end = route.places.begin() + static_cast<std::ptrdiff_t>(std::min(kBeginning, route.places.size()));
  return std::find(route.places.begin(), end, state.place) == end;
}

/// Returns whether the robot may know of this version of the route: then what it holds is of it.
bool Dispatcher::is_told(const RobotId& robot, const Route& route) const {
  const storage::PutOccupancy* const held = traffic_.held(robot);
  return held != nullptr && held->held.id == route.id && held->held.version == route.version;
}

/// Returns why an operator's hold keeps the robot from being released farther; empty: nobody holds it.
std::string Dispatcher::why_held(const RobotId& robot) const {
  const Robot* const known = fleet_.find(robot);
  if (known == nullptr || known->held_by.empty()) return {};
  return known->name + " is held by " + known->held_by + ": weft unhold " + known->name;
}

void Dispatcher::held_or_freed(const RobotId& robot) {
  look_again_ = true;
  planning_.want();
  const auto found = assignments_.find(robot);
  if (found != assignments_.end()) found->second.look_at_release = true;
}

void Dispatcher::send_order(const RobotId& robot, RouteAssignment& assignment, SteadyTime now) {
  Route route = *book_.route(assignment.goal);
  if (assignment.is_to_end()) {
    route = order_to_end(robot, route.goal, route.id, route.version, std::move(route.reason));
  } else {
    assignment.ordered_at = now;
  }
  assignment.wait = next_wait(assignment.wait);
  assignment.send_at = now + assignment.wait;
  context_.out.send(msg::RouteOrder{.header = {}, .to = robot, .route = std::move(route)});
}

/// Ends a route that the robot should not follow: one of a goal that is over, or that this server never gave out.
void Dispatcher::end_unknown(const RobotId& robot, const GoalId& goal, const RouteId& id) {
  const Route* const known = book_.route(goal);
  const std::uint32_t version = known != nullptr ? known->version : 1;
  context_.out.send(msg::RouteOrder{
      .header = {}, .to = robot, .route = order_to_end(robot, goal, id, version, "its goal is over")});
}

void Dispatcher::on_progress(const msg::RouteProgress& progress, Now now) {
  const RobotId robot = progress.header.sender;
  const auto found = assignments_.find(robot);
  const Route* const route = found == assignments_.end() ? nullptr : book_.route(found->second.goal);
  if (route == nullptr || route->id != progress.route) {
    end_unknown(robot, progress.goal, progress.route);
    return;
  }
  RouteAssignment& assignment = found->second;
  // The order to end it is repeated by the clock, not by its reports.
  if (assignment.is_to_end() || progress.version != route->version) return;
  arrivals_.on_report(robot, *route, progress, now.steady);
  assignment.find_again();
  assignment.missing_since.reset();
  assignment.latest_report = std::max(assignment.latest_report.value_or(0), progress.header.sequence);
  if (assignment.latest_report == progress.header.sequence) note_driven(*route, assignment, progress.at, now);
  assignment.has_latest_order = progress.released >= route->released;
  assignment.stands_at_end = assignment.has_latest_order && progress.phase == msg::RoutePhase::waiting;
  // Frees all but the end for a robot that stands there: standing touches nothing beyond.
  const bool stands = assignment.stands_at_end && progress.at >= route->released;
  traffic_.freed(robot, route->id, stands ? route->released : progress.freed);
  const std::string who = fleet_.name_of(robot);
  if (progress.phase == msg::RoutePhase::arrived) {
    const auto last = static_cast<std::uint32_t>(route->places.size() - 1);
    if (route->released < last) {
      ++context_.counters["dispatcher: arrived beyond what was released"];
      return;
    }
    traffic_.freed(robot, route->id, last);
    finish(robot, assignment, GoalState::succeeded, "arrived", who, now);
    return;
  }
  const bool can_be_bent =
      progress.reason == kNoPath && book_.find(assignment.goal)->kind == GoalKind::operator_asked;
  if (progress.phase == msg::RoutePhase::failed && can_be_bent && !std::exchange(assignment.was_bent, true)) {
    return recall(robot, assignment, who + " cannot drive as it was led", now);
  }
  if (progress.phase == msg::RoutePhase::failed && progress.reason == kGaveUpBlocked)
    return close_ahead(robot, assignment, now);
  if (progress.phase == msg::RoutePhase::failed) {
    finish(robot, assignment, GoalState::failed, progress.reason.empty() ? "the robot gave up" : progress.reason, who,
           now);
    return;
  }
  const Goal& goal = *book_.find(assignment.goal);
  if (goal.state != GoalState::assigned) return;
  // Not stored: the next report brings it again.
  std::ignore = book_.write(goal, {.state = GoalState::executing, .cause = "the robot has its route", .who = who},
                            std::nullopt, {}, now);
}

/// Notes that the robot could not drive there: it is asked to make way elsewhere for a while.
void Dispatcher::avoid(const RobotId& robot, const Route& route, SteadyTime now) {
  std::map<PlaceId, SteadyTime>& places = avoids_[robot];
  std::erase_if(places, [now](const auto& avoided) { return avoided.second <= now; });
  for (std::size_t i = 1; i < route.places.size(); ++i) places[route.places[i]] = now + kAvoidsFor;
}

/// Ends the goal, and its route where it was released to. What the robot holds stays held until it has forgotten the
/// route and says where it stands.
void Dispatcher::finish(const RobotId& robot, RouteAssignment& assignment, GoalState state, const std::string& cause,
                        const std::string& who, Now now) {
  const Goal& goal = *book_.find(assignment.goal);
  Route route = *book_.route(assignment.goal);
  route.ended = true;
  route.reason = cause;
  const bool told = is_told(robot, route) || traffic_.holds_route(robot, route.id);
  const std::vector<storage::PutPasses> passes = arrivals_.due(now.steady);
  storage::Transaction more;
  more.changes.assign(passes.begin(), passes.end());
  if (!book_.write(goal, {.state = state, .cause = cause, .who = who}, route, std::move(more), now)) {
    return arrivals_.put_back(passes);
  }
  arrivals_.ended(robot);
  overlay_.forget(goal.id);
  look_again_ = true;
  if (state == GoalState::succeeded && goal.kind == GoalKind::operator_asked) arrived_at_[robot] = now.steady;
  if (state == GoalState::failed && goal.kind == GoalKind::yield) avoid(robot, route, now.steady);
  planning_.want();
  if (!told) {
    assignments_.erase(robot);
    return;
  }
  assignment.standing = RouteAssignment::Standing::over;
  assignment.wait = Duration{};
  send_order(robot, assignment, now.steady);
}

bool Dispatcher::has_forgotten(const RouteAssignment& assignment, const msg::RobotState& state, const Route& route,
                               SteadyTime now) const {
  if (state.route == route.id) return false;
  // It had the route and says now that it has not; or no order to follow it can be on the way any more.
  const bool had_it = assignment.latest_report && *assignment.latest_report < state.header.sequence;
  return had_it || !assignment.ordered_at || now - *assignment.ordered_at > kLongestOnItsWay;
}

void Dispatcher::watch_for_loss(RouteAssignment& assignment, const Route& route, const msg::RobotState& state,
                                SteadyTime now) {
  const bool has_it = state.route == route.id;
  if (has_it) {
    assignment.missing_since.reset();
    if (state.route_version == route.version) assignment.find_again();
    if (!assignment.is_lost()) traffic_.follows(state.header.sender);
    return;
  }
  const bool had_it = assignment.latest_report && *assignment.latest_report < state.header.sequence;
  if (assignment.is_lost()) return;
  if (!had_it && !has_to_send(state.header.sender, assignment)) return assignment.missing_since.reset();
  if (!assignment.missing_since) assignment.missing_since = now;
  if (now - *assignment.missing_since < (had_it ? kLostAfter : kIgnoredAfter)) return;
  assignment.lose();
  if (!had_it) assignment.is_closed = true;
}

void Dispatcher::on_state(const Robot& robot, Now now) {
  const msg::RobotState& state = *robot.state;
  look_again_ = true;
  note_blocked(robot, now);
  const auto found = assignments_.find(robot.id);
  if (found == assignments_.end()) {
    // Its goal may have been given to another robot while it was not heard: it drives on to the end of what it holds.
    if (!state.route || !traffic_.holds_route(robot.id, state.route)) traffic_.stands(state, now);
    if (state.route) end_unknown(robot.id, state.goal, state.route);
    return;
  }
  RouteAssignment& assignment = found->second;
  assignment.is_hand_over_asked = false;
  const Route& route = *book_.route(assignment.goal);
  if (assignment.is_over()) {
    if (!has_forgotten(assignment, state, route, now.steady)) {
      // Cleared off its route, and not standing yet.
      if (!traffic_.holds_route(robot.id, route.id)) traffic_.stands(state, now);
      return;
    }
    assignments_.erase(found);
    look_at_ = now.steady;  // a goal that waits for it comes before its being asked to make way
    traffic_.stands(state, now);
    return;
  }
  if (assignment.standing == RouteAssignment::Standing::recalled) {
    if (!has_forgotten(assignment, state, route, now.steady)) return;
    assignment.is_closed = true;
    assignment.lose();
    traffic_.stands(state, now);
  }
  if (!is_told(robot.id, route) && !traffic_.holds_route(robot.id, route.id)) {
    traffic_.stands(state, now);
    // It was moved before it could set off.
    if (stands_elsewhere(state, route)) assignment.lose();
  } else {
    watch_for_loss(assignment, route, state, now.steady);
  }
  // It may have been put down elsewhere, also while it is stopped.
  if (!state.route && (assignment.is_lost() || assignment.missing_since)) traffic_.stands_without_route(state);
  if (assignment.is_lost()) replan(robot.id, assignment, now);
}

void Dispatcher::on_restart(const RobotId& robot) {
  const auto found = assignments_.find(robot);
  if (found == assignments_.end() || found->second.is_over()) return;
  found->second.lose();
  found->second.has_latest_order = false;
  found->second.latest_report.reset();
}

bool Dispatcher::has_to_send(const RobotId& robot, const RouteAssignment& assignment) const {
  if (assignment.is_to_end()) return true;
  if (assignment.has_latest_order || assignment.is_lost()) return false;
  const bool is_paused = book_.find(assignment.goal)->state == GoalState::paused;
  return !is_paused && is_told(robot, *book_.route(assignment.goal));
}

void Dispatcher::tick(Now now) {
  if (!std::exchange(routes_checked_, true)) {
    seen_rules_ = routes_.rules();
    for (auto& [robot, assignment] : assignments_) reroute(robot, assignment, now);
  }
  look_at_silent(now);
  look_at_closures(now);
  for (const RobotId& robot : traffic_.take_woken()) {
    const auto woken = assignments_.find(robot);
    if (woken == assignments_.end()) continue;
    woken->second.look_at_release = true;
    planning_.want_soon();
  }
  if (look_again_ && look_at_ <= now.steady) {
    look_again_ = false;
    look_at_ = now.steady + kBetweenLooksAtRoutes;
    look_at_charge(now);
    if (assign_waiting(now)) {
      send_idle_robots(now);
    } else {
      look_again_ = true;
      look_at_ = now.steady;
    }
  }
  if ((planning_.is_under_way() || needs_plan()) && planning_.is_due(now.steady)) plan_moves(now);
  for (auto& [robot, assignment] : assignments_) {
    if (!assignment.is_over()) tell_silence(robot, assignment, now);
  }
  release_some(now);
  for (auto& [robot, assignment] : assignments_) {
    if (assignment.send_at <= now.steady && has_to_send(robot, assignment)) send_order(robot, assignment, now.steady);
  }
}

void Dispatcher::excuse(Duration away, SteadyTime now) {
  for (auto& [robot, assignment] : assignments_) {
    for (std::optional<SteadyTime>* const since : {&assignment.ordered_at, &assignment.missing_since}) {
      if (*since) *since = std::min(**since + away, now);
    }
  }
}

std::optional<SteadyTime> Dispatcher::next() const {
  std::optional<SteadyTime> next;
  const auto sooner = [&next](SteadyTime at) { next = next ? std::min(*next, at) : at; };
  for (const auto& [robot, assignment] : assignments_) {
    if (has_to_send(robot, assignment)) sooner(assignment.send_at);
  }
  const bool anybody_waits = std::any_of(book_.alive().begin(), book_.alive().end(), [this](const auto& entry) {
    return book_.find(entry.second)->state == GoalState::pending;
  });
  if (look_again_ && anybody_waits) sooner(look_at_);
  if (traffic_.has_woken()) sooner(SteadyTime{});
  if (planning_.is_under_way() || needs_plan()) sooner(planning_.next());
  if (!planning_.is_under_way() && has_to_release()) sooner(SteadyTime{});
  for (const std::optional<SteadyTime>& at : {next_look_at_silent(), overlay_.next()}) {
    if (at) sooner(*at);
  }
  return next;
}

}  // namespace weft::server
