#include <algorithm>
#include <numeric>
#include <queue>
#include <tuple>

#include "tests/bench/traffic/fleet.hpp"

namespace weft::bench {
namespace {

constexpr int kAhead = 24;   // steps that are planned
constexpr int kBetween = 6;  // steps from one plan to the next
constexpr std::size_t kNobody = ~std::size_t{0};

/// Keeps who is in which cell at which step of a plan.
class Reserved {
 public:
  explicit Reserved(std::size_t cells) : by_(cells * (kAhead + 1), kNobody) {}
  std::size_t at(Cell cell, int step) const { return by_[cell * (kAhead + 1) + static_cast<std::size_t>(step)]; }
  void take(Cell cell, int step, std::size_t robot) {
    by_[cell * (kAhead + 1) + static_cast<std::size_t>(step)] = robot;
  }
  /// Returns whether the robot may be there at that step. Nobody follows: a cell is entered when it was empty the
  /// step before, and nobody enters what is left just then.
  bool may_be(std::size_t robot, Cell cell, int step, bool enters) const {
    const auto is_free = [&](int when) {
      return when < 0 || when > kAhead || at(cell, when) == kNobody || at(cell, when) == robot;
    };
    return is_free(step) && (!enters || is_free(step - 1)) && is_free(step + 1);
  }

 private:
  std::vector<std::size_t> by_;
};

/// Plans robot after robot, who has waited longest first, each round those before it: A* over cells and steps (Silver
/// 2005: windowed cooperative A*). The robots then pass each cell in the order planned, when it is empty.
class Prioritised final : public Policy {
 public:
  explicit Prioritised(Fleet& fleet) : fleet_(fleet), seen_(fleet.network().size() * (kAhead + 1)) {}

  void step() override {
    if (fleet_.now() % kBetween == 0) plan();
    const std::vector<Robot>& robots = fleet_.robots();
    std::vector<bool> is_taken(fleet_.network().size());
    for (const Robot& robot : robots) is_taken[robot.at] = true;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      std::vector<Cell>& way = ways_[i];
      if (robots[i].handles > 0 || way.empty() || fleet_.is_delayed()) continue;
      const Cell next = way.back();
      if (is_taken[next] || order_[next].empty() || order_[next].front() != i) continue;
      is_taken[next] = true;
      order_[next].erase(order_[next].begin());
      way.pop_back();
      fleet_.move(i, next);
    }
  }

  std::vector<server::Wait> waits() override {
    std::vector<server::Wait> all;
    const std::vector<Robot>& robots = fleet_.robots();
    for (std::size_t i = 0; i < robots.size(); ++i) {
      if (robots[i].handles > 0 || fleet_.now() - robots[i].stands_since < kBetween) continue;
      const std::vector<std::uint32_t>& steps = fleet_.steps_to(robots[i].goal);
      server::Wait wait;
      wait.robot = fleet_robot_id(i);
      // It waits for whoever stands on the cell that leads on.
      const std::vector<Cell>& next = fleet_.network().next[robots[i].at];
      const auto best =
          std::min_element(next.begin(), next.end(), [&](Cell a, Cell b) { return steps[a] < steps[b]; });
      for (std::size_t k = 0; k < robots.size(); ++k) {
        if (robots[k].at == *best) wait.held_by.insert(fleet_robot_id(k));
      }
      if (!wait.held_by.empty()) all.push_back(std::move(wait));
    }
    return all;
  }
  std::uint64_t overlaps() override {
    std::vector<Cell> cells;
    for (const Robot& robot : fleet_.robots()) cells.push_back(robot.at);
    std::sort(cells.begin(), cells.end());
    return static_cast<std::uint64_t>(cells.end() - std::unique(cells.begin(), cells.end()));
  }

 private:
  struct Seen {
    std::uint64_t search = 0;
    Cell from = 0;
  };
  struct Open {
    std::uint32_t cost = 0;
    int step = 0;
    Cell cell = 0;
    bool operator<(const Open& other) const {  // the cheapest is the top, of equal ones the farthest on
      return std::tie(other.cost, step, other.cell) < std::tie(cost, other.step, cell);
    }
  };

  void plan() {
    const std::vector<Robot>& robots = fleet_.robots();
    Reserved reserved(fleet_.network().size());
    ways_.assign(robots.size(), {});
    order_.assign(fleet_.network().size(), {});
    std::vector<std::vector<std::pair<int, std::size_t>>> visits(fleet_.network().size());
    std::vector<std::size_t> order(robots.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return robots[a].asked_at < robots[b].asked_at; });
    // Who handles stays as long as that takes; everybody is where it is now.
    for (std::size_t i = 0; i < robots.size(); ++i) {
      for (int step = 0; step <= std::min(robots[i].handles, kAhead); ++step) reserved.take(robots[i].at, step, i);
    }
    for (const std::size_t robot : order) {
      const std::vector<Cell> path = search(robot, reserved);
      for (std::size_t step = 0; step < path.size(); ++step) {
        reserved.take(path[step], static_cast<int>(step), robot);
        if (step == 0 || path[step] == path[step - 1]) continue;
        ways_[robot].push_back(path[step]);
        visits[path[step]].emplace_back(static_cast<int>(step), robot);
      }
      std::reverse(ways_[robot].begin(), ways_[robot].end());
    }
    for (Cell cell = 0; cell < visits.size(); ++cell) {
      std::sort(visits[cell].begin(), visits[cell].end());
      for (const auto& [step, robot] : visits[cell]) order_[cell].push_back(robot);
    }
  }

  /// Returns the robot's cell at each step; where it finds no way it stays where it is.
  std::vector<Cell> search(std::size_t robot, const Reserved& reserved) {
    const Robot& mine = fleet_.robots()[robot];
    const std::vector<std::uint32_t>& steps = fleet_.steps_to(mine.goal);
    ++search_;
    std::priority_queue<Open> open;
    const int begin = std::min(mine.handles, kAhead);
    open.push({steps[mine.at], begin, mine.at});
    seen_[index(mine.at, begin)] = {search_, mine.at};
    while (!open.empty()) {
      const Open here = open.top();
      open.pop();
      if (here.step == kAhead) return path_to(here.cell, mine.at, begin);
      std::vector<Cell> next = fleet_.network().next[here.cell];
      next.push_back(here.cell);
      for (const Cell cell : next) {
        const int step = here.step + 1;
        if (!reserved.may_be(robot, cell, step, cell != here.cell)) continue;
        Seen& seen = seen_[index(cell, step)];
        if (seen.search == search_) continue;
        seen = {search_, here.cell};
        open.push({static_cast<std::uint32_t>(step) + steps[cell], step, cell});
      }
    }
    return std::vector<Cell>(kAhead + 1, mine.at);
  }
  std::vector<Cell> path_to(Cell at, Cell begin_at, int begin) const {
    std::vector<Cell> path(kAhead + 1, begin_at);
    for (int step = kAhead; step > begin; --step) {
      path[static_cast<std::size_t>(step)] = at;
      at = seen_[index(at, step)].from;
    }
    return path;
  }
  static std::size_t index(Cell cell, int step) {
    return std::size_t{cell} * (kAhead + 1) + static_cast<std::size_t>(step);
  }

  Fleet& fleet_;
  std::vector<std::vector<Cell>> ways_;          ///< of each robot, the next cell last
  std::vector<std::vector<std::size_t>> order_;  ///< who enters each cell, the first one first
  std::vector<Seen> seen_;                       ///< by cell and step
  std::uint64_t search_ = 0;
};

}  // namespace

std::unique_ptr<Policy> make_prioritised(Fleet& fleet) {
  return std::make_unique<Prioritised>(fleet);
}

}  // namespace weft::bench
