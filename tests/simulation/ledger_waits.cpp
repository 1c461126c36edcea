#include <algorithm>

#include "tests/simulation/ledger.hpp"

/// Checks that the server tells why a robot stands, and that what it tells is true.
namespace weft::simulation {
namespace {

constexpr Duration kStands = std::chrono::seconds(10);
constexpr int kLooks = 3;  ///< in a row at which the same is wrong: what is told may be half a second old

/// Returns whether the robot waits for itself, by what is told of all robots.
bool waits_for_itself(const RobotId& robot, const std::map<RobotId, const msg::RobotRow*>& rows) {
  std::set<RobotId> seen;
  std::vector<RobotId> open = {robot};
  while (!open.empty()) {
    const auto row = rows.find(open.back());
    open.pop_back();
    if (row == rows.end() || !row->second->wait.at) continue;
    for (const RobotId& holder : row->second->wait.held_by) {
      if (holder == robot) return true;
      if (seen.insert(holder).second) open.push_back(holder);
    }
  }
  return false;
}

}  // namespace

/// Returns the route at whose released end the robot has stood for long, though more of it is to come; null: it does
/// not.
const Route* Ledger::stands_with(const RobotId& id, const Robot& robot, const storage::MemoryDisk& disk) const {
  if (!is_at_work(robot) || now_ - robot.stands_since < kStands) return nullptr;
  for (const auto& [goal_id, goal] : disk.goals) {
    if (goal.robot != id || goal.kind != GoalKind::operator_asked) continue;
    if (goal.state != GoalState::assigned && goal.state != GoalState::executing) continue;
    const auto found = disk.routes.find(goal_id);
    if (found == disk.routes.end() || found->second.ended) continue;
    const Route& route = found->second;
    const bool has_it = robot.had && robot.had->id == route.id && robot.had->version == route.version &&
                        robot.had->released == route.released;
    const bool is_at_end = robot.progress.route == route.id && robot.progress.at >= route.released;
    const bool is_untold = !robot.had && route.released == 0;
    const bool ends_here = route.released + 1 >= route.places.size();
    return !ends_here && ((has_it && is_at_end) || is_untold) ? &route : nullptr;
  }
  return nullptr;
}

/// Returns whether the robot holds something that near to the place, by what it was released, where it stands, and
/// where it has said that it stands.
bool Ledger::is_near(const RobotId& robot, const PlaceId& place, double within_m) const {
  const auto there = truth_of(place);
  if (!there) return false;
  const auto is_within = [&](const Pose2& at) { return (at.translation() - there->translation()).norm() < within_m; };
  if (is_within(robots.at(robot).body->site_from_robot())) return true;
  const auto known = known_.find(robot);
  const auto said = known != known_.end() ? truth_of(known->second.place) : std::nullopt;
  if (said && is_within(*said)) return true;
  const auto held = held_.find(robot);
  if (held == held_.end()) return false;
  const Route& route = held->second.route;
  for (std::uint32_t i = held->second.from; i <= route.released && i < route.places.size(); ++i) {
    const auto at = truth_of(route.places[i]);
    if (at && is_within(*at)) return true;
  }
  return false;
}

/// Returns whether the robot is on its way past that place, or past what is left of the way: another one may have to
/// let it go first.
bool Ledger::is_to_pass(const RobotId& robot, const PlaceId& place, const Route& way, double within_m,
                        const storage::MemoryDisk& disk) const {
  std::vector<PlaceId> places(way.places.begin() + std::min<std::ptrdiff_t>(way.released, std::ssize(way.places)),
                              way.places.end());
  places.push_back(place);
  const auto comes_by = [&](const PlaceId& at) {
    const auto here = truth_of(at);
    return std::ranges::any_of(places, [&](const PlaceId& other) {
      const auto there = truth_of(other);
      return here && there && (here->translation() - there->translation()).norm() < within_m;
    });
  };
  return std::ranges::any_of(disk.routes, [&](const auto& entry) {
    const Route& route = entry.second;
    if (route.robot != robot || route.ended || is_terminal(disk.goals.at(entry.first).state)) return false;
    return std::ranges::any_of(route.places, comes_by);
  });
}

/// Returns whether the robot is somewhere on what is left of the way: it may be in a lane that cannot be entered
/// until it has come out.
bool Ledger::is_ahead(const RobotId& robot, const Route& route, double within_m) const {
  const auto begin = route.places.begin() + std::min<std::ptrdiff_t>(route.released, std::ssize(route.places));
  return std::any_of(begin, route.places.end(),
                     [&](const PlaceId& place) { return is_near(robot, place, within_m); });
}

/// Returns what is wrong with what is told of the robot's wait; empty: it is so.
std::string Ledger::wrong_wait(const RobotId& id, const msg::RobotWait& wait, const Route& route,
                               const storage::MemoryDisk& disk) const {
  constexpr double holds_m = 2.5;   // what leases and the plan may keep off, and more
  constexpr double covers_m = 0.5;  // nobody can be there beside it
  if (!wait.at) return "nothing says why";
  if (!wait.rule.empty()) return {};
  if (wait.held_by.empty()) return "it waits for nobody";
  for (const RobotId& holder : wait.held_by) {
    const bool is_there = is_near(holder, wait.needs, holds_m) || is_ahead(holder, route, holds_m);
    if (!is_there && !is_to_pass(holder, wait.needs, route, holds_m, disk))
      return "it is said to wait for " + robots.at(holder).name + ", which is not there and not to pass";
  }
  for (const auto& [other, robot] : robots) {
    const bool is_named = std::ranges::find(wait.held_by, other) != wait.held_by.end();
    const bool is_known = held_.contains(other) && robot.state.localised;
    if (other != id && is_known && !is_named && is_near(other, wait.needs, covers_m))
      return "nothing says that it waits for " + robot.name + ", which holds what it needs";
  }
  return {};
}

void Ledger::look_at_waits(const std::vector<msg::RobotRow>& rows, const storage::MemoryDisk& disk) {
  std::map<RobotId, int> before = std::exchange(wrong_, {});
  if (disk.faults.full) {
    // Nobody can be released, and nothing be said of it but that.
    for (auto& [id, robot] : robots) robot.stands_since = now_;
    return;
  }
  std::map<RobotId, const msg::RobotRow*> by_robot;
  for (const msg::RobotRow& row : rows) by_robot[row.description.header.sender] = &row;
  for (const msg::RobotRow& row : rows) {
    const RobotId& id = row.description.header.sender;
    const Robot& robot = robots.at(id);
    const Route* const route = stands_with(id, robot, disk);
    if (route == nullptr) continue;
    ++stood_;
    std::string wrong = wrong_wait(id, row.wait, *route, disk);
    if (wrong.empty() && row.standstill.empty() && waits_for_itself(id, by_robot))
      wrong = "it waits for robots that wait for it, and no standstill is named";
    if (wrong.empty()) continue;
    const int looks = before[id] + 1;
    wrong_[id] = looks;
    if (looks < kLooks) continue;
    broken("named", robot.name + " stands at " + to_string(robot.state.place) + " since " +
                        std::to_string(seconds(now_ - robot.stands_since)) + " s with " +
                        to_string(route->places[route->released + 1]) + " before it" +
                        (row.wait.needs ? ", needs " + to_string(row.wait.needs) : "") + ": " + wrong);
  }
}

}  // namespace weft::simulation
