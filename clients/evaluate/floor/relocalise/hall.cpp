#include "clients/evaluate/floor/relocalise/hall.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft::evaluate::floor {
namespace {

using namespace agents;

constexpr double kLongestRowM = 40.0;
constexpr double kRowsApartM = 1.6;  // rows see no floor of one another, or little
constexpr double kMarginM = 3.0;     // to the walls
constexpr double kLampsApartM = 6.0;

std::vector<SitePoint> rows(std::size_t count, double row_m) {
  constexpr int kBends = 8;  // pieces of a half circle
  constexpr double kRadiusM = kRowsApartM / 2;
  std::vector<SitePoint> line;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = kMarginM + kRowsApartM * static_cast<double>(i);
    const bool goes_back = i % 2 == 1;
    const double from = kMarginM + (goes_back ? row_m : 0.0);
    const double to = kMarginM + (goes_back ? 0.0 : row_m);
    line.push_back({from, y});
    line.push_back({to, y});
    if (i + 1 == count) break;
    for (int k = 1; k < kBends; ++k) {
      const double turned = std::numbers::pi * k / kBends;
      line.push_back(
          {to + (goes_back ? -1.0 : 1.0) * kRadiusM * std::sin(turned), y + kRadiusM * (1.0 - std::cos(turned))});
    }
  }
  return line;
}

std::vector<sim::Lamp> lamps_of(const sim::Site& like, const sim::FloorSetup& floor) {
  std::vector<sim::Lamp> lamps;
  if (like.lamps.empty()) return lamps;
  std::size_t i = 0;
  for (double y = floor.y_min + 0.5 * kLampsApartM; y < floor.y_max; y += kLampsApartM) {
    for (double x = floor.x_min + 0.5 * kLampsApartM; x < floor.x_max; x += kLampsApartM) {
      sim::Lamp lamp = like.lamps[i++ % like.lamps.size()];
      lamp.x = x;
      lamp.y = y;
      lamps.push_back(lamp);
    }
  }
  return lamps;
}

}  // namespace

Hall hall_like(const sim::Site& like, double metres) {
  const double turn_m = std::numbers::pi * kRowsApartM / 2;
  const double row_m = std::min(metres, kLongestRowM);
  const auto count = static_cast<std::size_t>(std::ceil((metres + turn_m) / (row_m + turn_m) - 1e-9));
  Hall hall{like, rows(count, row_m)};
  sim::Site& site = hall.site;
  site.boxes.clear();
  site.stations.clear();
  site.floor.x_min = site.floor.y_min = 0.0;
  site.floor.x_max = row_m + 2 * kMarginM;
  site.floor.y_max = kRowsApartM * static_cast<double>(count - 1) + 2 * kMarginM;
  site.lamps = lamps_of(like, site.floor);
  site.robots.front().site_from_robot = {hall.line.front().x, hall.line.front().y, 0.0};
  return hall;
}

}  // namespace weft::evaluate::floor
