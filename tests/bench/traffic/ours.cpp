#include <algorithm>

#include "server/traffic/plan/planner.hpp"
#include "tests/bench/traffic/foretold.hpp"
#include "tests/bench/traffic/leased.hpp"

namespace weft::bench {
namespace {

constexpr std::uint32_t kTicksBetweenPlans = 2;  // about a second

/// Follows the rule of the product: moves are planned for all robots, and released in the order of the plan.
class Ours final : public Policy {
 public:
  explicit Ours(Fleet& fleet)
      : fleet_(fleet),
        leased_(fleet),
        foretold_(fleet),
        planner_(leased_.traffic().proximity(), server::PlanRules{}) {}

  void step() override {
    foretold_.look(leased_, kStep_s * fleet_.now());
    for (Leased::Way& way : leased_.ways()) way.is_delayed = fleet_.is_delayed();
    for (std::uint32_t tick = 0; tick < TaughtLanes::kPlacesOfCell; ++tick) {
      if (tick % kTicksBetweenPlans == 0) plan();
      leased_.pass_tick();
      for (std::size_t i = 0; i < leased_.ways().size(); ++i) leased_.drive(i);
      for (const RobotId& robot : leased_.traffic().take_woken()) is_blocked_[Leased::number(robot)] = false;
      release_all();
      foretold_.hear(leased_, kStep_s * (fleet_.now() + (tick + 1.0) / TaughtLanes::kPlacesOfCell));
    }
  }

  std::vector<server::Wait> waits() override { return leased_.waits(); }
  std::uint64_t overlaps() override { return leased_.overlaps(); }
  std::vector<Foreseen> foreseen() const override { return foretold_.foreseen(); }

 private:
  void plan() {
    std::vector<server::PlanRequest> requests;
    for (std::size_t i = 0; i < leased_.ways().size(); ++i) requests.push_back(request(i));
    planner_.plan({leased_.network(), &no_rules_}, kRadius_m, requests);
    is_blocked_.assign(requests.size(), false);
    release_all();
  }

  /// Releases until nobody gets on: who is released lets others follow.
  void release_all() {
    for (bool gets_on = true; gets_on;) {
      gets_on = false;
      for (std::uint32_t i = 0; i < leased_.ways().size(); ++i) gets_on = (!is_blocked_[i] && go_on(i)) || gets_on;
    }
  }

  server::PlanRequest request(std::size_t robot) {
    const Robot& mine = fleet_.robots()[robot];
    server::PlanRequest request;
    request.robot = fleet_robot_id(robot);
    request.drives = {{"marks"}, true};
    request.handles = static_cast<std::uint32_t>(mine.handles);
    request.waits_s = kStep_s * (fleet_.now() - mine.asked_at);
    const storage::PutOccupancy& held = *leased_.traffic().held(request.robot);
    request.held.assign(held.held.places.begin() + held.from, held.held.places.begin() + held.to + 1);
    const PlaceId goal = leased_.lanes().place(mine.goal);
    if (mine.handles == 0) request.goal = goal;
    return request;
  }

  /// Releases what is the robot's turn, as the next version of its route. Returns whether that was anything.
  bool go_on(std::uint32_t robot) {
    Leased::Way& way = leased_.ways()[robot];
    const server::PlanOrder& order = planner_.order();
    const std::uint32_t first = order.released(robot);
    const std::uint32_t held =
        way.route && way.is_told ? (way.route->released - way.at) / TaughtLanes::kPlacesOfCell : 0;
    const std::uint32_t last = planner_.may(robot, held);
    if (first == last) return false;
    const server::PlannedWay planned = planner_.way(robot, first, last);
    std::vector<Cell> cells = {cell_at(way, robot)};
    for (const std::uint32_t stop : planned.stops) cells.push_back(planned.places[stop].index);
    const Route more = leased_.lanes().route(cells);
    if (!way.route || (way.is_told && way.at == way.route->released && way.at > kLongRoute)) {
      leased_.begin(robot, more);
    } else {
      const std::uint32_t kept = way.is_told ? way.route->released : 0;
      way.route->places.resize(kept + std::size_t{1});
      way.route->relations.resize(kept);
      way.route->places.insert(way.route->places.end(), more.places.begin() + 1, more.places.end());
      way.route->relations.insert(way.route->relations.end(), more.relations.begin(), more.relations.end());
      ++way.route->version;
    }
    server::Traffic::Stops stops;
    for (std::uint32_t i = 0; i < way.route->places.size(); i += TaughtLanes::kPlacesOfCell) stops.push_back(i);
    const std::uint32_t before = way.is_told ? way.route->released : 0;
    leased_.release(robot, &stops);
    const std::uint32_t cells_released =
        way.is_told ? (way.route->released - before) / TaughtLanes::kPlacesOfCell : 0;
    planner_.release(robot, first + cells_released);
    is_blocked_[robot] = first + cells_released < last;
    return cells_released > 0;
  }

  Cell cell_at(const Leased::Way& way, std::size_t robot) const {
    if (!way.route || !way.is_told) return fleet_.robots()[robot].at;
    return way.route->places[way.route->released].index;
  }

  static constexpr std::uint32_t kLongRoute = 400;  // places

  Fleet& fleet_;
  Leased leased_;
  Foretold foretold_;
  const RuleMap no_rules_;
  server::Planner planner_;
  std::vector<bool> is_blocked_;  ///< by what others hold, until something of that is freed
};

}  // namespace

std::unique_ptr<Policy> make_ours(Fleet& fleet) {
  return std::make_unique<Ours>(fleet);
}

}  // namespace weft::bench
