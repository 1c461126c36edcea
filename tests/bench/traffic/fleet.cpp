#include "tests/bench/traffic/fleet.hpp"

#include <algorithm>
#include <numeric>

namespace weft::bench {
namespace {
constexpr std::size_t kGoalsKept = 4;  // of each robot's, with their distances
}  // namespace

RobotId fleet_robot_id(std::size_t robot) {
  RobotId id;
  id.bytes[0] = 1;
  id.bytes[14] = static_cast<std::uint8_t>(robot >> 8U);
  id.bytes[15] = static_cast<std::uint8_t>(robot);
  return id;
}

Fleet::Fleet(const Network& network, std::uint32_t robots, std::uint64_t seed) : network_(network), delays_(seed) {
  Random random(seed);
  std::vector<Cell> cells(network.size());
  std::iota(cells.begin(), cells.end(), 0U);
  for (std::uint32_t i = 0; i < robots; ++i) {
    std::swap(cells[i], cells[i + random.below(cells.size() - i)]);
    goals_.push_back(random.fork(i + 1));
    robots_.push_back({.at = cells[i]});
    robots_.back().goal = next_goal(i);
  }
}

Cell Fleet::next_goal(std::size_t robot) {
  Cell goal = robots_[robot].at;
  while (goal == robots_[robot].at) goal = static_cast<Cell>(goals_[robot].below(network_.size()));
  return goal;
}

const std::vector<std::uint32_t>& Fleet::steps_to(Cell goal) {
  const auto known = steps_.find(goal);
  if (known != steps_.end()) return known->second;
  if (steps_.size() >= kGoalsKept * robots_.size()) {
    std::vector<Cell> wanted;
    for (const Robot& robot : robots_) wanted.push_back(robot.goal);
    std::sort(wanted.begin(), wanted.end());
    std::erase_if(steps_,
                  [&](const auto& entry) { return !std::binary_search(wanted.begin(), wanted.end(), entry.first); });
  }
  return steps_.emplace(goal, bench::steps_to(network_, goal)).first->second;
}

void Fleet::move(std::size_t robot, Cell to) {
  Robot& moved = robots_[robot];
  if (moved.at == to) return;
  if (now_ > moved.stands_since) waits.push_back(now_ - moved.stands_since);
  moved.at = to;
  moved.stands_since = now_ + 1;
}

void Fleet::end_step() {
  ++now_;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    if (robot.handles == 0) oldest = std::max(oldest, now_ - robot.asked_at);
    if (robot.handles > 0) {
      if (--robot.handles > 0) continue;
      robot.goal = next_goal(i);
      robot.asked_at = now_;
      robot.stands_since = now_;
    } else if (robot.at == robot.goal) {
      ++goals_done;
      robot.handles = kHandling;
    }
  }
}

}  // namespace weft::bench
