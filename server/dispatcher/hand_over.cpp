#include <algorithm>
#include <chrono>
#include <cmath>

#include "server/dispatcher/dispatcher.hpp"

/// Gives goals of robots that are not heard any more to others.
namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenLooksAtSilent = 1s;

}  // namespace

/// Returns why the robot's goal is not handed over whatever is set; empty: it may be.
std::string Dispatcher::keeps_goal(const RobotId& robot, const RouteAssignment& assignment) const {
  const Robot* const known = fleet_.find(robot);
  const Goal& goal = *book_.find(assignment.goal);
  const std::string name = fleet_.name_of(robot);
  if (known != nullptr && !known->silent) return name + " is heard: weft goal cancel ends the goal";
  if (assignment.is_over() || is_terminal(goal.state)) return std::string("it is over: ") + to_string(goal.state);
  if (goal.kind != GoalKind::operator_asked) return "it is no operator's";
  if (goal.wanted) return "it was asked for " + name + " alone: weft goal cancel, and send another robot";
  if (goal.state == GoalState::paused) return "it is paused: weft resume " + name;
  return {};
}

/// Puts the goal back among those that wait for any robot. The robot's route is stored as ended in the same
/// transaction, so that no goal is driven by two robots. What the robot holds stays held: it may still be on its way,
/// and is told by the route's id to stand when it is heard again.
Result<void> Dispatcher::hand_over(const RobotId& robot, const std::string& cause, const std::string& who, Now now) {
  const GoalId id = assignments_.at(robot).goal;
  Goal goal = *book_.find(id);
  Route ended = *book_.route(id);
  ended.ended = true;
  ended.reason = cause;
  goal.robot.reset();
  goal.route.reset();
  storage::Transaction transaction;
  transaction.changes.emplace_back(storage::PutRoute{std::move(ended)});
  const GoalBook::Step step = {.state = GoalState::pending, .cause = cause, .who = who, .kind = "goal.handed_over"};
  if (Result<void> stored = book_.write(std::move(goal), step, std::nullopt, std::move(transaction), now); !stored) {
    return stored;
  }
  assignments_.erase(robot);
  forget_waiting(id);
  planning_.want();
  look_again_ = true;
  look_at_ = now.steady;
  return {};
}

msg::OperatorReply Dispatcher::hand_over(const GoalId& id, const std::string& who, Now now) {
  msg::OperatorReply reply;
  reply.goal = id;
  reply.outcome = msg::Outcome::refused;
  const Goal* const goal = book_.find(id);
  if (goal == nullptr) {
    reply.message = "there is no goal " + to_string(id) + ": weft goal list";
    return reply;
  }
  const auto found = goal->robot ? assignments_.find(*goal->robot) : assignments_.end();
  if (found == assignments_.end() || found->second.goal != id) {
    reply.message = "no robot has it: it is " + std::string(to_string(goal->state));
    return reply;
  }
  const RobotId robot = found->first;
  reply.message = keeps_goal(robot, found->second);
  if (!reply.message.empty()) return reply;
  const std::string name = fleet_.name_of(robot);
  if (const Result<void> done = hand_over(robot, "taken from " + name, who, now); !done) {
    reply.outcome = msg::Outcome::failed;
    reply.message = "nothing was changed: " + done.error().message;
    return reply;
  }
  reply.outcome = msg::Outcome::done;
  reply.message = "taken from " + name + ", for any other robot; what " + name +
                  " held stays held until it is heard, or cleared: weft robot clear " + name;
  return reply;
}

void Dispatcher::look_at_silent(Now now) {
  if (context_.config.silent_goal == SilentGoal::keep || now.steady < look_at_silent_) return;
  look_at_silent_ = now.steady + kBetweenLooksAtSilent;
  std::vector<RobotId> robots;
  for (const auto& [robot, assignment] : assignments_) {
    const Robot* const known = fleet_.find(robot);
    if (known == nullptr || seconds(now.steady - known->heard) < context_.config.silent_goal_after_s) continue;
    if (keeps_goal(robot, assignment).empty()) robots.push_back(robot);
  }
  for (const RobotId& robot : robots) {
    const auto silent_s = std::lround(seconds(now.steady - fleet_.find(robot)->heard));
    const std::string why = fleet_.name_of(robot) + " has not been heard for " + std::to_string(silent_s) + " s";
    if (context_.config.silent_goal == SilentGoal::hand_over) {
      // Is tried again in a second where the store takes nothing.
      std::ignore = hand_over(robot, why + ": another robot may have the goal", "dispatcher", now);
    } else if (!std::exchange(assignments_.at(robot).is_hand_over_asked, true)) {
      const GoalId id = assignments_.at(robot).goal;
      wait_for(*book_.find(id), why + ": weft goal hand-over " + to_string(id).substr(0, 8) + " lets another have it",
               now);
    }
  }
}

/// Notes in the goal's history that its robot is not heard, and later that it is: what it waited for before is not
/// what it waits for then.
void Dispatcher::tell_silence(const RobotId& robot, RouteAssignment& assignment, Now now) {
  const Robot* const known = fleet_.find(robot);
  if (known == nullptr || known->silent == assignment.is_silence_told) return;
  assignment.is_silence_told = known->silent;
  const Goal& goal = *book_.find(assignment.goal);
  if (known->silent) return wait_for(goal, known->name + " is not heard; what it was released stays held", now);
  assignment.noted_way = {};
  assignment.look_at_release = true;
  // Lost only if the store takes nothing; what it waits for is noted all the same.
  std::ignore = book_.write(
      goal,
      {.state = goal.state, .cause = known->name + " is heard again", .who = "dispatcher", .kind = "goal.goes_on"},
      std::nullopt, {}, now);
}

/// Returns when a goal is next looked at whose robot is not heard; none: there is none.
std::optional<SteadyTime> Dispatcher::next_look_at_silent() const {
  if (context_.config.silent_goal == SilentGoal::keep) return std::nullopt;
  const bool any = std::any_of(assignments_.begin(), assignments_.end(), [this](const auto& entry) {
    return !entry.second.is_hand_over_asked && keeps_goal(entry.first, entry.second).empty();
  });
  return any ? std::optional(look_at_silent_) : std::nullopt;
}

}  // namespace weft::server
