#include "tests/bench/traffic/foretold.hpp"

#include <algorithm>
#include <cmath>

namespace weft::bench {

void Foretold::hear(Leased& leased, double now_s) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Leased::Way& way = leased.ways()[i];
    if (!way.route || fleet_.robots()[i].handles > 0) continue;
    const bool waits = way.at == way.route->released;
    robots_[i].passing.on_report(*way.route, way.at, waits ? msg::RoutePhase::waiting : msg::RoutePhase::driving,
                                 SteadyTime(from_seconds(now_s)), speeds_);
  }
}

void Foretold::look(Leased& leased, double now_s) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Followed& mine = robots_[i];
    const Robot& robot = fleet_.robots()[i];
    if (robot.handles > 0) {
      mine.passing.end(speeds_);
      if (!mine.open) continue;
      const Open& open = *mine.open;
      const double real_s = now_s - open.at_s;
      band_.add(real_s, open.left_s);
      foreseen_.push_back({.error = std::abs(open.left_s - real_s) / real_s,
                           .is_in_band = real_s >= open.soonest_s && real_s <= open.latest_s});
      mine.open.reset();
      continue;
    }
    const std::uint32_t steps = fleet_.steps_to(robot.goal)[robot.at];
    if (mine.asked_at != robot.asked_at) {
      mine.asked_at = robot.asked_at;
      mine.steps = steps;
      mine.open.reset();
    }
    if (mine.open || mine.steps == 0 || 2 * steps > mine.steps) continue;
    mine.steps = 0;
    const double left_s = speeds_.left(way_left(leased.ways()[i], i, leased.lanes()), 0).total_s();
    mine.open = {now_s, left_s, band_.soonest() * left_s, band_.latest() * left_s};
  }
}

/// Returns the way that the robot was released, and on by a shortest one.
Route Foretold::way_left(const Leased::Way& way, std::size_t robot, const TaughtLanes& lanes) {
  const Robot& mine = fleet_.robots()[robot];
  std::vector<Cell> cells = {mine.at};
  if (way.route && way.is_told) {
    for (std::uint32_t at = way.at + 1; at <= way.route->released; ++at) {
      if (at % TaughtLanes::kPlacesOfCell == 0) cells.push_back(way.route->places[at].index);
    }
  }
  const std::vector<std::uint32_t>& steps = fleet_.steps_to(mine.goal);
  while (cells.back() != mine.goal) {
    const std::vector<Cell>& next = fleet_.network().next[cells.back()];
    cells.push_back(*std::min_element(next.begin(), next.end(), [&](Cell a, Cell b) { return steps[a] < steps[b]; }));
  }
  return lanes.route(cells);
}

}  // namespace weft::bench
