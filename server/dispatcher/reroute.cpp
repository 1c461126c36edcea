#include <algorithm>
#include <utility>

#include "core/network/search.hpp"
#include "server/dispatcher/dispatcher.hpp"

/// Reroutes robots under way when the map is edited (docs/path-of-a-goal.md, 6).
namespace weft::server {
namespace {

bool leads_on(const Snapshot& snapshot, const PlaceId& from, const PlaceId& to) {
  bool leads = false;
  snapshot.for_each_edge(
      from, [&](const Edge& edge) { leads = leads || (other_end(edge, from) == to && can_drive(edge, from)); });
  return leads;
}

/// Returns the index of the first place, after `from`, that the map does not lead to any more along the route; `from`
/// itself when it is out; none when the route is whole.
std::optional<std::uint32_t> first_broken(const Snapshot& snapshot, const Route& route, std::uint32_t from) {
  if (from >= route.places.size()) return std::nullopt;
  if (snapshot.place(route.places[from]) == nullptr) return from;
  for (std::uint32_t at = from + 1; at < route.places.size(); ++at) {
    if (!leads_on(snapshot, route.places[at - 1], route.places[at])) return at;
  }
  return std::nullopt;
}

}  // namespace

void Dispatcher::network_changed() {
  look_again_ = true;
  planning_.see(context_.snapshots.shared_current());
  if (routes_.rules() != seen_rules_) {
    seen_rules_ = routes_.rules();
    tried_.clear();
    choosing_.clear();
    routes_checked_ = false;
    planning_.want();
    for (auto& [robot, assignment] : assignments_) assignment.ruled_by.clear();
  }
  const bool any_cut_short =
      std::any_of(assignments_.begin(), assignments_.end(), [](const auto& entry) { return entry.second.cut_short; });
  // What was added may lead on where something was taken away.
  if (any_cut_short) routes_checked_ = false;
}

void Dispatcher::reroute(const RobotId& robot, RouteAssignment& assignment, Now now) {
  if (assignment.standing != RouteAssignment::Standing::followed) return;
  const Route& route = *book_.route(assignment.goal);
  const bool told = is_told(robot, route);
  std::optional<std::uint32_t> broken =
      first_broken(context_.snapshots.current(), route, told ? traffic_.held(robot)->from : 0);
  // Looks beyond the released point alone: rules let those leave who are inside.
  if (!broken) broken = first_barred(routes_.rules(), route, told ? route.released : 0, keeps_limits(robot));
  if (!broken) {
    const bool was_cut_short = std::exchange(assignment.cut_short, false);
    if (was_cut_short || !assignment.ruled_by.empty()) assignment.look_at_release = true;
    const bool is_limited_anew = limits_of(routes_.rules(), route.places) != route.limits;
    if (is_limited_anew && told) limit_anew(robot, assignment, now);
    if (is_limited_anew && !told) assignment.lose();
    return;
  }
  if (!told) {
    assignment.lose();  // as if it had been moved: from where it says that it stands
  } else if (*broken > route.released) {
    replan_ahead(robot, assignment, now);
  } else {
    recall(robot, assignment, "the map was changed under " + fleet_.name_of(robot), now);
  }
}

/// Plans the next version of the route beyond its released point. It begins with all that was released, so that the
/// robot need not stop and holds what it held.
void Dispatcher::replan_ahead(const RobotId& robot, RouteAssignment& assignment, Now now) {
  const Goal& goal = *book_.find(assignment.goal);
  const Route& route = *book_.route(assignment.goal);
  const Robot* const known = fleet_.find(robot);
  if (known == nullptr || !known->description)
    return cut_off(robot, assignment, "its robot has not been heard yet", now);
  const Result<Choice> choice = choose({{.robot = robot,
                                         .at = route.places[route.released],
                                         .methods = methods_of(*known),
                                         .keeps_limits = known->description->knows_limits}},
                                       ways_for(goal, now));
  if (!choice) return cut_off(robot, assignment, choice.error().message, now);
  Route next = route;
  const auto kept = static_cast<std::ptrdiff_t>(route.released);
  next.version = route.version + 1;
  next.made_of = context_.snapshots.current().revision();
  next.reason.clear();
  next.places.erase(next.places.begin() + kept, next.places.end());
  next.relations.erase(next.relations.begin() + kept, next.relations.end());
  next.places.insert(next.places.end(), choice->path.places.begin(), choice->path.places.end());
  next.relations.insert(next.relations.end(), choice->path.relations.begin(), choice->path.relations.end());
  next.limits = limits_of(routes_.rules(), next.places);
  const GoalBook::Step step = {.state = goal.state,
                               .cause = "the map was changed ahead of " + known->name + ": it goes on from " +
                                        to_string(route.places[route.released]) + " another way",
                               .who = "dispatcher",
                               .kind = "goal.planned_anew"};
  put_version(robot, assignment, next, step, now);
}

/// Tells the robot which speed limits hold along its route now: as its next version, which it answers to.
void Dispatcher::limit_anew(const RobotId& robot, RouteAssignment& assignment, Now now) {
  const Goal& goal = *book_.find(assignment.goal);
  Route next = *book_.route(assignment.goal);
  next.limits = limits_of(routes_.rules(), next.places);
  next.version += 1;
  next.made_of = context_.snapshots.current().revision();
  const GoalBook::Step step = {.state = goal.state,
                               .cause = "other speed limits hold on the way of " + fleet_.name_of(robot),
                               .who = "dispatcher",
                               .kind = "goal.limited_anew"};
  put_version(robot, assignment, next, step, now);
}

/// Gives the robot the next version of its route, which begins with all that was released, and holds that under it.
void Dispatcher::put_version(const RobotId& robot, RouteAssignment& assignment, const Route& next,
                             const GoalBook::Step& step, Now now) {
  const std::vector<storage::PutOccupancy> claims = traffic_.claim(next, traffic_.held(robot)->from, next.released);
  storage::Transaction transaction;
  for (const storage::PutOccupancy& claim : claims) transaction.changes.emplace_back(claim);
  if (!book_.write(*book_.find(assignment.goal), step, next, std::move(transaction), now)) {
    routes_checked_ = false;  // the store takes nothing now; nothing more of the old one is released meanwhile
    assignment.cut_short = true;
    return;
  }
  traffic_.committed(claims);
  assignment.cut_short = false;
  assignment.has_latest_order = false;
  assignment.latest_report.reset();
  assignment.look_at_release = true;
  assignment.stands_at_end = false;
  assignment.waits_since.reset();
  assignment.wait = Duration{};
  send_order(robot, assignment, now.steady);
}

/// Lets the robot stop at its released point, and says why.
void Dispatcher::cut_off(const RobotId& robot, RouteAssignment& assignment, const std::string& why, Now now) {
  assignment.cut_short = true;
  if (!assignment.waits_since) assignment.waits_since = now;
  const Goal& goal = *book_.find(assignment.goal);
  if (goal.kind != GoalKind::operator_asked)
    return finish(robot, assignment, GoalState::cancelled, why, "traffic", now);
  const std::string cause = "the map was changed ahead of " + fleet_.name_of(robot) + ": " + why;
  if (goal.history.back().cause == cause) return;
  Route next = *book_.route(assignment.goal);
  next.reason = clipped(cause);
  if (!book_.write(goal, {.state = goal.state, .cause = cause, .who = "dispatcher", .kind = "goal.waits"}, next, {},
                   now)) {
    return;  // said again at the next change of the map
  }
  assignment.wait = Duration{};
  send_order(robot, assignment, now.steady);
}

/// Has the robot stop, and plans from where it stands.
void Dispatcher::recall(const RobotId& robot, RouteAssignment& assignment, const std::string& why, Now now,
                        const char* kind) {
  const Goal& goal = *book_.find(assignment.goal);
  assignment.standing = RouteAssignment::Standing::recalled;
  assignment.wait = Duration{};
  // Told even when it cannot be written down: to stand is more urgent.
  std::ignore = book_.write(goal,
                            {.state = goal.state,
                             .cause = why + ": it stops, and is given another route from where it stands",
                             .who = "dispatcher",
                             .kind = kind},
                            std::nullopt, {}, now);
  send_order(robot, assignment, now.steady);
}

}  // namespace weft::server
