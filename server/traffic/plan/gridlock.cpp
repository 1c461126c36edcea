#include "server/traffic/plan/gridlock.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace weft::server {
namespace {

/// Is over how many berths a robot is led away: past the next crossing and the lane behind it.
constexpr std::size_t kLedOver = 6;

/// Returns whether the robot stands where others could ask it to move.
bool stands(const MovePlan& plan, const std::vector<PlanRobot>& robots, std::size_t robot) {
  const PlanRobot& known = robots[robot];
  return known.at != kNoBerth && !known.stays && known.handles == 0 && plan.moves[robot].empty();
}

/// Adds to those that are gridlocked who keeps them.
void add_keepers(const MovePlan& plan, std::vector<bool>& locked) {
  std::vector<std::size_t> robots;
  for (std::size_t robot = 0; robot < locked.size(); ++robot) {
    if (locked[robot]) robots.push_back(robot);
  }
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (const std::uint32_t other : plan.kept_by[robots[i]]) {
      if (locked[other]) continue;
      locked[other] = true;
      robots.push_back(other);
    }
  }
}

}  // namespace

std::vector<bool> gridlocked(const MovePlan& plan, const std::vector<PlanRobot>& robots) {
  std::vector<bool> stand(robots.size());
  std::vector<bool> locked(robots.size());
  for (std::size_t robot = 0; robot < robots.size(); ++robot) {
    stand[robot] = stands(plan, robots, robot);
    locked[robot] = stand[robot] && robots[robot].goal != nullptr && !plan.kept_by[robot].empty();
  }
  // Takes out who waits for one that moves, or that cannot, and then who waits for those.
  bool has_changed = true;
  while (std::exchange(has_changed, false)) {
    for (std::size_t robot = 0; robot < robots.size(); ++robot) {
      if (!locked[robot]) continue;
      const bool is_locked = std::ranges::all_of(plan.kept_by[robot], [&](std::uint32_t other) {
        return locked[other] || (stand[other] && robots[other].goal == nullptr);
      });
      has_changed = has_changed || !is_locked;
      locked[robot] = is_locked;
    }
  }
  add_keepers(plan, locked);
  return locked;
}

bool keep_others(const MovePlan& plan, const std::vector<PlanRobot>& robots, const std::vector<bool>& some) {
  std::vector<bool> keeps = some;
  bool has_changed = std::find(keeps.begin(), keeps.end(), true) != keeps.end();
  const auto does_keep = [&](std::uint32_t other) { return keeps[other]; };
  while (std::exchange(has_changed, false)) {
    for (std::size_t robot = 0; robot < robots.size(); ++robot) {
      const std::vector<std::uint32_t>& by = plan.kept_by[robot];
      if (keeps[robot] || !plan.moves[robot].empty() || std::none_of(by.begin(), by.end(), does_keep)) continue;
      if (robots[robot].goal != nullptr) return true;
      keeps[robot] = has_changed = true;
    }
  }
  return false;
}

LedAway led_away_of(SafeStates& states, const MovePlan& plan, const std::vector<PlanRobot>& robots,
                    const std::vector<bool>& locked, const std::function<std::uint64_t(std::uint32_t)>& led_at) {
  std::vector<bool> keeps(robots.size());
  for (std::size_t robot = 0; robot < robots.size(); ++robot) {
    for (const std::uint32_t other : plan.kept_by[robot]) keeps[other] = keeps[other] || locked[robot];
  }
  const auto rank = [&](std::uint32_t robot) {
    return std::tuple(led_at(robot), !keeps[robot], robots[robot].waits_s);
  };
  LedAway one;
  for (std::uint32_t robot = 0; robot < robots.size(); ++robot) {
    if (!locked[robot] || !stands(plan, robots, robot)) continue;
    if (one.robot != kNobody && rank(one.robot) <= rank(robot)) continue;
    const std::vector<Berth>& avoids = robots[robot].avoids;
    std::vector<Berth> over = states.way_out(robot, kLedOver);
    if (!over.empty() && std::ranges::find_first_of(over, avoids) == over.end()) one = {robot, std::move(over)};
  }
  return one;
}

}  // namespace weft::server
