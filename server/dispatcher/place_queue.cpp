#include <algorithm>

#include "server/dispatcher/dispatcher.hpp"

/// Keeps a second robot from setting off to where another one goes, or works: its goal waits. Nobody waits for a
/// robot that does not move by itself, and goals for one place are given out in their turn, so that none waits for
/// ever.
namespace weft::server {

/// Returns who comes first where the goal leads; none: the goal may be given to one of those that are ready.
std::optional<RobotId> Dispatcher::who_comes_first_at(const Goal& goal, const std::vector<Candidate>& ready,
                                                      Now now) {
  for (const auto& [robot, assignment] : assignments_) {
    const Goal& other = *book_.find(assignment.goal);
    const bool goes_there = !assignment.is_over() && other.to == goal.to && other.kind != GoalKind::park;
    if (goes_there && goal.wanted != robot && !stays(robot)) return robot;
  }
  for (const RobotId& robot : traffic_.near(goal.to, {})) {
    const bool is_asked = std::ranges::find(ready, robot, &Candidate::robot) != ready.end();
    if (!is_asked && is_handling(robot, now) && is_at_rest(robot)) return robot;
  }
  return std::nullopt;
}

/// Returns whether the robot stands idle where it has come to, or has yet to forget how.
bool Dispatcher::is_at_rest(const RobotId& robot) const {
  const auto found = assignments_.find(robot);
  return found == assignments_.end() ? stays(robot) == Stays::idle : found->second.is_over();
}

/// Returns why a goal that somebody is ready for is not given out yet; empty: it is.
std::string Dispatcher::why_another_first(const Goal& goal, const std::vector<Candidate>& ready, Queues& queues,
                                          Now now) {
  if (queues.places.contains(goal.to)) return "goals for " + goal.label + " that were asked for earlier come first";
  const std::optional<RobotId> first = who_comes_first_at(goal, ready, now);
  if (!first) return {};
  queues.places.insert(goal.to);
  return fleet_.name_of(*first) + " is at " + goal.label + " or on its way there; it comes next";
}

}  // namespace weft::server
