#include <cmath>

#include "tests/simulation/ledger.hpp"

/// Checks that goals get on without people, by one robot each, and not into what is closed.
namespace weft::simulation {
namespace {

constexpr double kFreeSpeed_m_s = 0.5;

/// Returns how long its robot would drive if nobody else were there.
double driving_s(const Route& route) {
  double length_m = 0.0;
  for (const Relation& relation : route.relations) length_m += planar(relation).translation().norm();
  return length_m / kFreeSpeed_m_s;
}

bool is_given(const Goal& goal) {
  return goal.robot && !is_terminal(goal.state) && goal.state != GoalState::pending;
}

}  // namespace

/// Returns whether the robot is there, knows where it is, and does what it is told.
bool Ledger::is_at_work(const Robot& robot) const {
  const bool is_still = robot.state.mode == msg::RobotMode::lost || robot.state.mode == msg::RobotMode::teaching ||
                        robot.state.mode == msg::RobotMode::stopped || robot.state.mode == msg::RobotMode::faulted;
  // After a stop of its base it stands until it has seen where it is, and says so itself.
  const bool looks_round = robot.state.reason.find("seen where it is") != std::string::npos;
  return robot.agent != nullptr && !robot.is_hung && !robot.is_cut_off && !robot.body->by_hand() &&
         robot.state.localised && !is_still && !looks_round;
}

/// Returns whether nothing excuses the goal: the one that has it, or whose turn it is, could drive.
bool Ledger::counts(const Goal& goal, const std::set<RobotId>& busy) const {
  if (goal.state == GoalState::paused || is_edited_ || is_ruled_) return false;
  if (is_given(goal)) return is_at_work(robots.at(*goal.robot));
  for (const auto& [id, robot] : robots) {
    const bool is_meant = !goal.wanted || *goal.wanted == id;
    if (is_meant && !busy.contains(id) && is_at_work(robot) && robot.state.mode == msg::RobotMode::idle) return true;
  }
  return false;
}

void Ledger::look_at_goals(const storage::MemoryDisk& disk, bool is_served) {
  std::set<RobotId> busy;
  for (const auto& [id, goal] : disk.goals) {
    if (is_given(goal)) busy.insert(*goal.robot);
  }
  std::vector<GoalSight> sights;
  const bool is_sound = is_served && !disk.faults.full && disk.faults.fail_next == 0;
  for (const auto& [id, goal] : disk.goals) {
    if (is_terminal(goal.state)) continue;
    GoalSight sight{id, goal.kind, {}, is_sound && counts(goal, busy)};
    const auto route = disk.routes.find(id);
    if (route != disk.routes.end()) sight.free_s = driving_s(route->second);
    sights.push_back(sight);
  }
  for (const Progress::Late& late : progress_.look(now_, sights)) {
    const Goal& goal = disk.goals.at(late.goal.id);
    const std::string robot = goal.robot ? robots.at(*goal.robot).name : "nobody";
    broken(goal.kind == GoalKind::yield ? "yields" : "progress",
           "goal " + to_string(goal.id) + " of " + robot + " to " + goal.label + " is " + to_string(goal.state) +
               " after " + std::to_string(std::lround(late.spent_s)) + " s, at most " +
               std::to_string(std::lround(late.most_s)) + ": " + goal.history.back().cause);
  }
}

/// Checks that no goal is driven by two robots. Who was not heard for long and stands where it was released to is
/// told of the hand-over when it is heard again; until then it has the goal, and does not drive.
void Ledger::check_driver(const RobotId& id, const Robot& robot) {
  if (robot.agent == nullptr) return;
  const std::optional<GoalId> goal = robot.had ? std::optional(robot.had->goal) : std::nullopt;
  if (!goal || !*goal) return;
  const auto [driver, is_new] = drivers_.emplace(*goal, id);
  if (is_new || driver->second == id) return;
  const Robot& other = robots.at(driver->second);
  const bool drives_too = now_ - other.drove < std::chrono::seconds(1) && !other.is_cut_off;
  if (drives_too && other.had && other.had->goal == *goal) {
    broken("once", "goal " + to_string(*goal) + " is driven by " + robot.name + ", and " + other.name + " has it");
  }
  driver->second = id;
}

/// Checks that a route is not released into what was closed already when that was released: its places from `next`
/// on. What an earlier version was released as well, from `first` on, has to state its limits again.
void Ledger::check_rules(const Route& route, std::uint32_t first, std::uint32_t next, const Snapshot& snapshot) {
  for (const auto& [name, rule] : snapshot.rules()) {
    const auto truth = [this](const PlaceId& id) { return truth_of(id); };
    const bool is_closed = rule.kind == RuleKind::closed && !rule.one_direction;
    if (const auto place = is_closed ? enters_closed(rule, route, next, truth) : std::nullopt) {
      broken("rules", robots.at(route.robot).name + " was released to " + to_string(*place) + " which rule " + name +
                          " closes");
    }
    const bool is_slow = rule.kind == RuleKind::speed;
    if (const auto place = is_slow ? lacks_limit(rule, route, first, truth) : std::nullopt) {
      broken("limits", robots.at(route.robot).name + " was released to " + to_string(*place) + " which rule " + name +
                           " slows, without its limit");
    }
  }
}

}  // namespace weft::simulation
