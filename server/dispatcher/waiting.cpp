#include "server/dispatcher/dispatcher.hpp"

/// Tells which robots wait for which, and which do not move at all: by what is stored, and what they answered to
/// that.
namespace weft::server {

/// Returns the wait of a robot before which a rule, or what was taken out of the map, bars the way; none: it still
/// drives.
std::optional<Wait> Dispatcher::wait_at_barrier(const RobotId& robot, const RouteAssignment& assignment) const {
  const Route& route = *book_.route(assignment.goal);
  if (!assignment.stands_at_end || !assignment.waits_since) return std::nullopt;
  const std::uint32_t released = route.released;
  const Passage passage{.begins = route.places[released], .keeps_limits = keeps_limits(robot)};
  Wait wait = barred_wait(robot, assignment, released, passage);
  if (wait.rule.empty() && released + 1 < route.places.size()) wait.needs = route.places[released + 1];
  return wait;
}

/// Returns the wait of a robot that has no route, as a rule bars what it was to drive, or some of that is closed for
/// its goal; none: neither.
std::optional<Wait> Dispatcher::wait_without_route(const RobotId& robot, const RouteAssignment& assignment) const {
  const Robot* const known = fleet_.find(robot);
  if (!assignment.waits_since || known == nullptr || !known->state || !known->state->place) return std::nullopt;
  const Passage passage{.begins = known->state->place, .keeps_limits = keeps_limits(robot)};
  Wait wait = barred_wait(robot, assignment, 0, passage);
  if (!wait.rule.empty()) return wait;
  const std::vector<Closure>& closed = overlay_.of(assignment.goal);
  if (closed.empty()) return std::nullopt;
  wait.needs = closed.back().to;
  return wait;
}

/// Returns the wait of a robot where the passage begins, for the first rule on its route from `from` on.
Wait Dispatcher::barred_wait(const RobotId& robot, const RouteAssignment& assignment, std::uint32_t from,
                             const Passage& passage) const {
  const Route& route = *book_.route(assignment.goal);
  Wait wait{
      .robot = robot, .at = passage.begins, .needs = {}, .held_by = {}, .since = *assignment.waits_since, .rule = {}};
  if (const auto at = first_barred(routes_.rules(), route, from, passage.keeps_limits)) {
    wait.needs = route.places[*at];
    // The passage begins where it does for `first_barred`: on the route, beside which the robot may stand.
    const Passage begun{.begins = route.places[from], .keeps_limits = passage.keeps_limits};
    const Rule* const rule = routes_.rules().barrier(route.places[*at - 1], wait.needs, begun);
    if (rule != nullptr) wait.rule = rule->name;
  }
  return wait;
}

std::vector<Wait> Dispatcher::waits() {
  std::vector<Wait> all;
  for (const auto& [robot, assignment] : assignments_) {
    const bool is_paused = book_.find(assignment.goal)->state == GoalState::paused;
    if (assignment.is_to_end() || (assignment.is_lost() && is_paused)) continue;
    if (assignment.is_lost() || assignment.cut_short) {
      std::optional<Wait> wait =
          assignment.is_lost() ? wait_without_route(robot, assignment) : wait_at_barrier(robot, assignment);
      if (wait) all.push_back(*std::move(wait));
      continue;
    }
    const bool is_let_on = assignment.way.end == Traffic::Way::End::free && assignment.ruled_by.empty();
    if (is_let_on || is_paused || !assignment.waits_since) continue;
    const Route& route = *book_.route(assignment.goal);
    const bool told = is_told(robot, route);
    const bool drives = told && (!assignment.stands_at_end || route.released + 1 == route.places.size());
    if (drives) continue;
    if (!assignment.ruled_by.empty()) {
      const std::uint32_t next = told ? route.released + 1 : 1;
      all.push_back({.robot = robot,
                     .at = route.places[next - 1],
                     .needs = next < route.places.size() ? route.places[next] : PlaceId{},
                     .held_by = {},
                     .since = *assignment.waits_since,
                     .rule = assignment.ruled_by});
      continue;
    }
    Wait wait{.robot = robot,
              .at = route.places[told ? route.released : 0],
              .needs = assignment.way.needs.place,
              .held_by = traffic_.holders_of(robot, assignment.way),
              .since = *assignment.waits_since,
              .rule = {}};
    const bool is_for_robots =
        assignment.way.end == Traffic::Way::End::held || assignment.way.end == Traffic::Way::End::turn;
    const bool is_free = is_for_robots && wait.held_by.empty();
    if (!is_free) all.push_back(std::move(wait));
  }
  return all;
}

std::optional<Stays> Dispatcher::stays(const RobotId& robot) const {
  const Robot* const known = fleet_.find(robot);
  if (known == nullptr || known->silent || !known->state) return Stays::silent;
  if (known->incarnations.twins()) return Stays::paused;
  const msg::RobotState& state = *known->state;
  if (state.mode == msg::RobotMode::teaching) return std::nullopt;
  if (is_stop(state.safety)) return Stays::stopped;
  if (!known->held_by.empty()) return Stays::held;
  if (state.mode == msg::RobotMode::faulted) return Stays::faulted;
  if (state.mode == msg::RobotMode::lost || !state.localised) return Stays::lost;
  if (blocked_for_long_.contains(robot)) return Stays::blocked;
  const auto found = assignments_.find(robot);
  if (found == assignments_.end()) {
    if (state.mode == msg::RobotMode::stopped) return Stays::paused;
    return state.mode == msg::RobotMode::idle ? std::optional(Stays::idle) : std::nullopt;
  }
  const RouteAssignment& assignment = found->second;
  if (assignment.is_over()) return std::nullopt;
  if (book_.find(assignment.goal)->state == GoalState::paused) return Stays::paused;
  if (assignment.cut_short || assignment.is_lost()) return Stays::no_way;
  if (!assignment.ruled_by.empty() && assignment.stands_at_end) return Stays::ruled;
  return std::nullopt;
}

}  // namespace weft::server
