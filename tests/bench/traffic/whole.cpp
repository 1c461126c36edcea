#include <algorithm>

#include "tests/bench/traffic/leased.hpp"

namespace weft::bench {
namespace {

/// Follows the rule before there was a plan: a route is released as far as nobody else holds anything, held until it
/// is driven, and asked for again when something is freed.
class Whole final : public Policy {
 public:
  /// Lets, with `asks_all`, everybody who waits ask again after each report that frees something, as before watches.
  Whole(Fleet& fleet, bool asks_all) : fleet_(fleet), asks_all_(asks_all), leased_(fleet) {}

  void step() override {
    auto& ways = leased_.ways();
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (fleet_.robots()[i].handles == 0 && !ways[i].route) set_off(i);
      ways[i].is_delayed = fleet_.is_delayed();
    }
    for (std::uint32_t tick = 0; tick < TaughtLanes::kPlacesOfCell; ++tick) {
      leased_.pass_tick();
      for (std::size_t i = 0; i < ways.size(); ++i) drive(i);
      for (const RobotId& robot : leased_.traffic().take_woken()) leased_.release(Leased::number(robot), nullptr);
    }
  }

  std::vector<server::Wait> waits() override { return leased_.waits(); }
  std::uint64_t overlaps() override { return leased_.overlaps(); }

 private:
  void set_off(std::size_t robot) {
    const Robot& mine = fleet_.robots()[robot];
    const std::vector<std::uint32_t>& steps = fleet_.steps_to(mine.goal);
    std::vector<Cell> cells = {mine.at};
    while (cells.back() != mine.goal) {
      const std::vector<Cell>& next = fleet_.network().next[cells.back()];
      cells.push_back(
          *std::min_element(next.begin(), next.end(), [&](Cell a, Cell b) { return steps[a] < steps[b]; }));
    }
    leased_.begin(robot, leased_.lanes().route(cells));
    leased_.release(robot, nullptr);
  }

  void drive(std::size_t robot) {
    if (!leased_.drive(robot)) return;
    Leased::Way& way = leased_.ways()[robot];
    for (std::size_t other = 0; asks_all_ && other < leased_.ways().size(); ++other) leased_.release(other, nullptr);
    if (way.at + 1 == way.route->places.size()) way.route.reset();
  }

  Fleet& fleet_;
  bool asks_all_;
  Leased leased_;
};

}  // namespace

std::unique_ptr<Policy> make_whole(Fleet& fleet) {
  return std::make_unique<Whole>(fleet, false);
}

std::unique_ptr<Policy> make_whole_asking_all(Fleet& fleet) {
  return std::make_unique<Whole>(fleet, true);
}

}  // namespace weft::bench
