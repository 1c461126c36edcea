#include "clients/evaluate/bearing/relocalise/aisles.hpp"

#include <numbers>
#include <string>
#include <utility>

namespace weft::evaluate::bearing {
namespace {

using agents::SitePoint;
using agents::sim::Box;

constexpr std::uint64_t kLeftOut = 77;  // stream of randomness
constexpr double kRackM = 10.8;         // four bays
constexpr double kDeepM = 1.0;
constexpr double kHighM = 4.5;
constexpr double kWideM = 3.0;                   // between the racks
constexpr double kApartM = kWideM + 2 * kDeepM;  // of the aisles' middles
constexpr double kCrossM = 4.0;                  // before and behind the racks
constexpr double kLampsApartM = 3.6;
constexpr double kBeforeM = 1.5;  // the racks begin
constexpr double kSlowsM = 0.3;   // the hand, before the way's end
constexpr double kAsideM = 0.1;   // standard deviation
constexpr double kAskewRad = 0.1;

double middle_y(std::size_t aisle) {
  return kDeepM + 0.5 * kWideM + kApartM * static_cast<double>(aisle);
}

double end_of_line() {
  return kCrossM + kRackM - kBeforeM;
}

Box rack(std::string name, double y) {
  return {Box::Kind::rack, std::move(name), {kCrossM + 0.5 * kRackM, y, 0.0}, kRackM, kDeepM, kHighM};
}

/// Names a rack; what it holds follows from its name.
std::string name_of_rack(const char* side, std::size_t aisle, bool is_alike) {
  return std::string(side) + (is_alike ? "" : " " + std::to_string(aisle));
}

PutDown led_along_x(const Pose2& from, bool is_onwards) {
  const double to = from.x + (is_onwards ? 1.0 : -1.0) * (kLedM + kSlowsM);
  return {from, {{from.x, from.y}, {to, from.y}}};
}

}  // namespace

std::vector<std::size_t> Aisles::taught() const {
  std::vector<std::size_t> aisles;
  for (std::size_t aisle = 0; aisle < kCount; ++aisle)
    if (aisle != left_out) aisles.push_back(aisle);
  return aisles;
}

std::vector<SitePoint> Aisles::line(std::size_t aisle) const {
  return {{kCrossM - kBeforeM, middle_y(aisle)}, {end_of_line(), middle_y(aisle)}};
}

Aisles aisles_like(const agents::sim::Site& like, Loads loads, std::uint64_t seed) {
  Aisles aisles{like, Random(seed).fork(kLeftOut).below(Aisles::kCount)};
  agents::sim::Site& site = aisles.site;
  site.boxes.clear();
  site.stations.clear();
  site.lamps.clear();
  site.movers.clear();
  site.floor.x_min = site.floor.y_min = 0.0;
  site.floor.x_max = kRackM + 2 * kCrossM;
  site.floor.y_max = kApartM * Aisles::kCount;
  site.floor.seed = seed;
  site.change.seed = seed;
  for (std::size_t aisle = 0; aisle < Aisles::kCount; ++aisle) {
    const double off_m = 0.5 * (kWideM + kDeepM);
    site.boxes.push_back(rack(name_of_rack("right", aisle, loads != Loads::other), middle_y(aisle) - off_m));
    site.boxes.push_back(rack(name_of_rack("left", aisle, loads == Loads::same), middle_y(aisle) + off_m));
    for (double x = 0.5 * kLampsApartM; x < site.floor.x_max; x += kLampsApartM)
      site.lamps.push_back({x, middle_y(aisle)});
  }
  site.robots.resize(1);
  site.robots.front().site_from_robot = {kCrossM - kBeforeM, middle_y(0), 0.0};
  return aisles;
}

PutDown on_the_line(std::size_t aisle, Random& random) {
  const double x = random.uniform(kCrossM - kBeforeM, end_of_line() - kLedM);
  return led_along_x({x, middle_y(aisle) + kAsideM * random.normal(), kAskewRad * random.normal()}, true);
}

PutDown anywhere(Random& random) {
  constexpr double kFreeM = 0.5;  // of racks and walls
  constexpr double kWayM = kLedM + kSlowsM;
  const double heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  const bool is_onwards = random.chance(0.5);
  if (random.chance(0.5)) {
    const double aside_m = 0.5 * kWideM - kFreeM;
    const double y = middle_y(random.below(Aisles::kCount)) + random.uniform(-aside_m, aside_m);
    const double x = kCrossM + random.uniform(0.0, kRackM - kWayM) + (is_onwards ? 0.0 : kWayM);
    return led_along_x({x, y, heading}, is_onwards);
  }
  const double x = random.uniform(kFreeM, kCrossM - kFreeM) + (random.chance(0.5) ? kRackM + kCrossM : 0.0);
  const double most_y = kApartM * Aisles::kCount - kFreeM - kWayM;
  const double y = random.uniform(kFreeM, most_y) + (is_onwards ? 0.0 : kWayM);
  return {{x, y, heading}, {{x, y}, {x, y + (is_onwards ? kWayM : -kWayM)}}};
}

}  // namespace weft::evaluate::bearing
