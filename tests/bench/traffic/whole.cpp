#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <tuple>

#include "server/traffic/traffic.hpp"
#include "storage/memory/memory_store.hpp"
#include "tests/bench/traffic/fleet.hpp"
#include "tests/bench/traffic/taught_lanes.hpp"

namespace weft::bench {
namespace {

constexpr double kRadius_m = 0.35;
/// Bounds how near robots' middles may come: what is held must be farther apart.
constexpr double kTouch_m = 2 * kRadius_m;

server::ServiceConfig config_of() {
  server::ServiceConfig config;
  config.self = fleet_robot_id(65'000);
  config.incarnation = 1;
  return config;
}

/// The rule of the product, by its own Traffic: a route is released as far as nobody else holds anything, held until
/// it is driven, and asked for again when something is freed.
class Whole final : public Policy {
 public:
  /// `asks_all`: everybody who waits asks again after each report that frees something, as it was before watches.
  Whole(Fleet& fleet, bool asks_all)
      : fleet_(fleet),
        asks_all_(asks_all),
        lanes_(fleet.network()),
        config_(config_of()),
        store_(storage::make_memory_store(std::make_shared<storage::MemoryDisk>())),
        out_(config_.self, 1, Epoch{1}),
        writer_(*store_, lanes_.snapshot(), out_, counters_),
        maintenance_(*store_),
        context_{config_, *store_, out_, counters_, writer_, writer_.snapshots(), maintenance_},
        traffic_(context_, standing(), now()),
        ways_(fleet.robots().size()) {
    for (std::size_t i = 0; i < ways_.size(); ++i) traffic_.set_footprint(fleet_robot_id(i), kRadius_m);
    while (traffic_.is_laying_out()) {
      clock_ += std::chrono::seconds(1);
      traffic_.tick(now());
    }
  }

  void step() override {
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      if (fleet_.robots()[i].handles == 0 && !ways_[i].route) set_off(i);
      ways_[i].is_delayed = fleet_.is_delayed();
    }
    for (std::uint32_t tick = 0; tick < TaughtLanes::kPlacesOfCell; ++tick) {
      clock_ += from_seconds(kStep_s / TaughtLanes::kPlacesOfCell);
      for (std::size_t i = 0; i < ways_.size(); ++i) drive(i);
      for (const RobotId& robot : traffic_.take_woken()) release(number(robot));
      out_.take();
    }
  }

  std::vector<server::Wait> waits() override {
    std::vector<server::Wait> all;
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      Way& way = ways_[i];
      const bool stands =
          way.route && way.at == way.route->released && way.said.end == server::Traffic::Way::End::held;
      if (!stands) continue;
      server::Wait wait;
      wait.robot = fleet_robot_id(i);
      wait.at = way.route->places[way.at];
      wait.needs = way.said.needs.place;
      wait.held_by = traffic_.holders_of(wait.robot, way.said);
      if (!wait.held_by.empty()) all.push_back(std::move(wait));
    }
    return all;
  }

  /// Counts overlaps by where the places truly lie.
  std::uint64_t overlaps() override {
    std::map<std::pair<long, long>, std::vector<std::pair<std::size_t, Eigen::Vector2d>>> near;
    const auto square = [](const Eigen::Vector2d& at) {
      return std::pair(std::lround(at.x() / kTouch_m), std::lround(at.y() / kTouch_m));
    };
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      const storage::PutOccupancy* const held = traffic_.held(fleet_robot_id(i));
      for (std::uint32_t k = held->from; k <= held->to; ++k) {
        const Eigen::Vector2d& at = lanes_.at(held->held.places[k]);
        const auto [x, y] = square(at);
        for (long dx = -1; dx <= 1; ++dx) {
          for (long dy = -1; dy <= 1; ++dy) {
            for (const auto& [other, there] : near[{x + dx, y + dy}]) {
              if (other != i && (there - at).norm() < kTouch_m) pairs.insert({other, i});
            }
          }
        }
        near[{x, y}].emplace_back(i, at);
      }
    }
    return pairs.size();
  }

 private:
  struct Way {
    std::optional<Route> route;
    std::uint32_t at = 0;
    bool is_told = false;  ///< something of the route is released
    bool is_delayed = false;
    server::Traffic::Way said;
  };

  server::Now now() const { return {.steady = clock_, .wall = WallTime(clock_.time_since_epoch())}; }
  static std::size_t number(const RobotId& robot) { return robot.bytes[14] * 256U + robot.bytes[15]; }

  std::map<RobotId, storage::PutOccupancy> standing() const {
    std::map<RobotId, storage::PutOccupancy> all;
    for (std::size_t i = 0; i < fleet_.robots().size(); ++i) {
      storage::PutOccupancy occupancy;
      occupancy.robot = fleet_robot_id(i);
      occupancy.held.robot = occupancy.robot;
      occupancy.held.places = {lanes_.place(fleet_.robots()[i].at)};
      all[occupancy.robot] = std::move(occupancy);
    }
    return all;
  }

  void set_off(std::size_t robot) {
    const Robot& mine = fleet_.robots()[robot];
    const std::vector<std::uint32_t>& steps = fleet_.steps_to(mine.goal);
    std::vector<Cell> cells = {mine.at};
    while (cells.back() != mine.goal) {
      const std::vector<Cell>& next = fleet_.network().next[cells.back()];
      cells.push_back(
          *std::min_element(next.begin(), next.end(), [&](Cell a, Cell b) { return steps[a] < steps[b]; }));
    }
    Way& way = ways_[robot];
    way = {.route = lanes_.route(cells), .at = 0, .is_told = false, .is_delayed = way.is_delayed, .said = {}};
    way.route->robot = fleet_robot_id(robot);
    way.route->id.bytes = way.route->robot.bytes;
    ++routes_;
    for (std::size_t i = 0; i < sizeof(routes_); ++i) {
      way.route->id.bytes[i + 2] = static_cast<std::uint8_t>(routes_ >> (8 * i));
    }
    release(robot);
  }

  void release(std::size_t robot) {
    Way& way = ways_[robot];
    if (!way.route || (way.is_told && way.route->released + 1 == way.route->places.size())) return;
    Route& route = *way.route;
    way.said = traffic_.way(route, way.is_told ? route.released + 1 : 0);
    if (!way.said.through) return;
    route.released = *way.said.through;
    traffic_.committed(traffic_.claim(route, way.is_told ? traffic_.held(route.robot)->from : 0, route.released));
    way.is_told = true;
  }

  void drive(std::size_t robot) {
    Way& way = ways_[robot];
    if (!way.is_told || !way.route || way.is_delayed || way.at == way.route->released) return;
    ++way.at;
    traffic_.freed(way.route->robot, way.route->id, way.at);
    for (std::size_t other = 0; asks_all_ && other < ways_.size(); ++other) release(other);
    if (way.at % TaughtLanes::kPlacesOfCell != 0) return;
    fleet_.move(robot, way.route->places[way.at].index);
    if (way.at + 1 == way.route->places.size()) way.route.reset();
  }

  Fleet& fleet_;
  bool asks_all_;
  TaughtLanes lanes_;
  SteadyTime clock_{std::chrono::seconds(1000)};
  server::ServiceConfig config_;
  server::Counters counters_;
  std::unique_ptr<storage::MapStore> store_;
  server::Outbox out_;
  server::MapWriter writer_;
  server::Maintenance maintenance_;
  server::Context context_;
  server::Traffic traffic_;
  std::vector<Way> ways_;
  std::uint64_t routes_ = 0;
};

}  // namespace

std::unique_ptr<Policy> make_whole(Fleet& fleet) {
  return std::make_unique<Whole>(fleet, false);
}

std::unique_ptr<Policy> make_whole_asking_all(Fleet& fleet) {
  return std::make_unique<Whole>(fleet, true);
}

}  // namespace weft::bench
