#include "tests/bench/traffic/leased.hpp"

#include <chrono>
#include <cmath>
#include <set>
#include <utility>

#include "storage/memory/memory_store.hpp"

namespace weft::bench {
namespace {

/// Bounds how near robots' middles may come: what is held must be farther apart.
constexpr double kTouch_m = 2 * kRadius_m;

server::ServiceConfig config_of() {
  server::ServiceConfig config;
  config.self = fleet_robot_id(65'000);
  config.incarnation = 1;
  return config;
}

}  // namespace

Leased::Leased(Fleet& fleet)
    : fleet_(fleet),
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

std::map<RobotId, storage::PutOccupancy> Leased::standing() const {
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

void Leased::begin(std::size_t robot, Route route) {
  Way& way = ways_[robot];
  way = {.route = std::move(route), .at = 0, .is_told = false, .is_delayed = way.is_delayed, .said = {}};
  way.route->robot = fleet_robot_id(robot);
  way.route->id.bytes = way.route->robot.bytes;
  ++routes_;
  for (std::size_t i = 0; i < sizeof(routes_); ++i) {
    way.route->id.bytes[i + 2] = static_cast<std::uint8_t>(routes_ >> (8 * i));
  }
}

void Leased::release(std::size_t robot, const std::vector<std::uint32_t>* stops) {
  Way& way = ways_[robot];
  if (!way.route || (way.is_told && way.route->released + 1 == way.route->places.size())) return;
  Route& route = *way.route;
  way.said = traffic_.way(route, way.is_told ? route.released + 1 : 0, stops);
  if (!way.said.through) return;
  route.released = *way.said.through;
  traffic_.committed(traffic_.claim(route, way.is_told ? traffic_.held(route.robot)->from : 0, route.released));
  way.is_told = true;
}

void Leased::pass_tick() {
  clock_ += from_seconds(kStep_s / TaughtLanes::kPlacesOfCell);
  out_.take();
}

bool Leased::drive(std::size_t robot) {
  Way& way = ways_[robot];
  if (!way.is_told || !way.route || way.is_delayed || way.at == way.route->released) return false;
  ++way.at;
  traffic_.freed(way.route->robot, way.route->id, way.at);
  if (way.at % TaughtLanes::kPlacesOfCell == 0) fleet_.move(robot, way.route->places[way.at].index);
  return true;
}

std::vector<server::Wait> Leased::waits() {
  std::vector<server::Wait> all;
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    Way& way = ways_[i];
    const bool stands = way.route && way.at == way.route->released && way.said.end == server::Traffic::Way::End::held;
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

std::uint64_t Leased::overlaps() {
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

}  // namespace weft::bench
