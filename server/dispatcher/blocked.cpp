#include <algorithm>
#include <chrono>
#include <utility>

#include "server/base/clipped.hpp"
#include "server/dispatcher/dispatcher.hpp"

/// Leads robots round what they find in their way: the floor before them is closed for their goal, and for what the
/// server asks of them by itself (docs/path-of-a-goal.md, 7).
namespace weft::server {
namespace {
using namespace std::chrono_literals;

/// Bounds how long a robot may be blocked before others are led round it, and it is led another way.
constexpr Duration kBlockedForLong = 30s;

}  // namespace

/// Notes since when the robot is blocked. Once it is for long, says so, and has it go another way.
void Dispatcher::note_blocked(const Robot& robot, Now now) {
  if (robot.state->safety != Safety::blocked) {
    blocked_since_.erase(robot.id);
    if (blocked_for_long_.erase(robot.id) > 0) planning_.want();
    return;
  }
  const SteadyTime since = blocked_since_.try_emplace(robot.id, now.steady).first->second;
  if (now.steady - since < kBlockedForLong || !blocked_for_long_.insert(robot.id).second) return;
  planning_.want();
  const Goal* const goal = goal_of(robot.id);
  context_.writer.note({.at = {},
                        .kind = "robot.blocked",
                        .robot = robot.id,
                        .goal = goal != nullptr ? goal->id : GoalId{},
                        .cause = "it is asked to drive and does not move: see what holds it",
                        .who = robot.name},
                       now);
  const auto found = assignments_.find(robot.id);
  if (found == assignments_.end() || found->second.is_to_end()) return;
  const Route& route = *book_.route(found->second.goal);
  if (robot.state->route == route.id && is_told(robot.id, route)) close_ahead(robot.id, found->second, now);
}

/// Closes what the robot has in front of it. Ends an operator's goal's route, not the goal: it is led another way.
/// Lets a robot that stands at its goal, before which nothing is left to be closed, try once more. Fails a goal of
/// the server's own: the next one leads elsewhere, or another way.
void Dispatcher::close_ahead(const RobotId& robot, RouteAssignment& assignment, Now now) {
  const Route& route = *book_.route(assignment.goal);
  const std::string name = fleet_.name_of(robot);
  const bool is_own = book_.find(assignment.goal)->kind != GoalKind::operator_asked;
  const ClosedFor whom = is_own ? ClosedFor::own_goals : ClosedFor::goal;
  const Closure* const closure = overlay_.close(context_.snapshots.current(), route, assignment.at, name, whom, now);
  const std::string why = closure != nullptr ? text_of(*closure) : name + " is blocked at its goal";
  if (is_own) return finish(robot, assignment, GoalState::failed, clipped(why), name, now);
  forget_waiting(assignment.goal);
  recall(robot, assignment, why, now, "goal.blocked");
}

/// Notes how far the robot has come, and opens what is closed where it has driven.
void Dispatcher::note_driven(const Route& route, RouteAssignment& assignment, std::uint32_t at, Now now) {
  const std::uint32_t from = std::exchange(assignment.at, at);
  if (overlay_.empty()) return;
  opened(overlay_.take_driven(route, from, at), fleet_.name_of(route.robot) + " has driven it", now);
}

/// Opens what has been closed for long enough.
void Dispatcher::look_at_closures(Now now) {
  opened(overlay_.take_over(now.steady), "it has been closed for long enough", now);
}

/// Has goals for which something was closed try again.
void Dispatcher::opened(const std::vector<Overlay::Opened>& all, const std::string& why, Now now) {
  for (const auto& [id, closure] : all) {
    const Goal* const goal = book_.find(id);
    if (goal == nullptr || is_terminal(goal->state)) continue;
    forget_waiting(id);
    look_again_ = true;
    look_at_ = now.steady;
    routes_checked_ = false;
    planning_.want();
    // Lost only if the store takes nothing; the way is looked for all the same.
    std::ignore = book_.write(*goal,
                              {.state = goal->state,
                               .cause = "between " + to_string(closure.from) + " and " + to_string(closure.to) +
                                        " the way is open again for this goal: " + why,
                               .who = "dispatcher",
                               .kind = "goal.goes_on"},
                              std::nullopt, {}, now);
  }
}

/// Returns what is closed for the goal while that robot drives to it; null: nothing is.
const ClosedHops* Dispatcher::closed_for(const Goal& goal, const RobotId& robot) const {
  return goal.kind == GoalKind::operator_asked ? overlay_.closed(goal.id) : overlay_.closed(robot);
}

/// Says what is closed for the goal, for people; empty: nothing is.
std::string Dispatcher::closed_text(const GoalId& goal) const {
  std::string text;
  for (const Closure& closure : overlay_.of(goal)) text += (text.empty() ? "" : "; ") + text_of(closure);
  return text;
}

}  // namespace weft::server
