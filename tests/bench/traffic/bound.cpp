#include <algorithm>
#include <numeric>

#include "tests/bench/traffic/fleet.hpp"

namespace weft::bench {
namespace {

/// Moves robots by priority inheritance with backtracking (Okumura et al., AIJ 2022, algorithm 1): all move at once,
/// into cells that others leave in the same step, and nobody is delayed. No fleet under leases can do that; what it
/// gets done is what others are measured by.
class Bound final : public Policy {
 public:
  explicit Bound(Fleet& fleet) : fleet_(fleet) {}

  void step() override {
    const std::vector<Robot>& robots = fleet_.robots();
    wish_.assign(robots.size(), kNoCell);
    wished_by_.assign(fleet_.network().size(), kNobody);
    stands_.assign(fleet_.network().size(), kNobody);
    for (std::size_t i = 0; i < robots.size(); ++i) stands_[robots[i].at] = i;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      if (robots[i].handles > 0) take(i, robots[i].at);
    }
    std::vector<std::size_t> order(robots.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return robots[a].asked_at < robots[b].asked_at; });
    for (const std::size_t robot : order) {
      if (wish_[robot] == kNoCell) wish(robot, kNobody);
    }
    for (std::size_t i = 0; i < robots.size(); ++i) fleet_.move(i, wish_[i]);
  }
  std::vector<server::Wait> waits() override { return {}; }
  std::uint64_t overlaps() override {
    std::vector<Cell> cells;
    for (const Robot& robot : fleet_.robots()) cells.push_back(robot.at);
    std::sort(cells.begin(), cells.end());
    return static_cast<std::uint64_t>(cells.end() - std::unique(cells.begin(), cells.end()));
  }

 private:
  static constexpr std::size_t kNobody = ~std::size_t{0};

  void take(std::size_t robot, Cell cell) {
    wish_[robot] = cell;
    wished_by_[cell] = robot;
  }
  bool wish(std::size_t robot, std::size_t pusher) {
    const Cell here = fleet_.robots()[robot].at;
    const std::vector<std::uint32_t>& steps = fleet_.steps_to(fleet_.robots()[robot].goal);
    std::vector<Cell> cells = fleet_.network().next[here];
    cells.push_back(here);
    std::stable_sort(cells.begin(), cells.end(), [&](Cell a, Cell b) { return steps[a] < steps[b]; });
    for (const Cell cell : cells) {
      if (wished_by_[cell] != kNobody) continue;
      if (pusher != kNobody && cell == fleet_.robots()[pusher].at) continue;
      const std::size_t other = stands_[cell];
      if (other != kNobody && other != robot && wish_[other] == here) continue;  // they would change places
      take(robot, cell);
      if (other == kNobody || other == robot || wish_[other] != kNoCell || wish(other, robot)) return true;
    }
    take(robot, here);
    return false;
  }

  Fleet& fleet_;
  std::vector<Cell> wish_;
  std::vector<std::size_t> wished_by_;
  std::vector<std::size_t> stands_;
};

}  // namespace

std::unique_ptr<Policy> make_bound(Fleet& fleet) {
  return std::make_unique<Bound>(fleet);
}

}  // namespace weft::bench
