#include "clients/evaluate/odometry/regions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/floor/measures.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::odometry {
namespace {

Region region_of(const std::vector<Row>& rows, const std::string& observer, double metres,
                 std::vector<double> Row::*stretches) {
  std::map<std::uint64_t, std::vector<double>> by_robot;
  for (const Row& row : rows) {
    if (row.drive != kMappingDrive || row.observer != observer || (row.*stretches).empty()) continue;
    std::vector<double>& all = by_robot[row.seed];
    all.insert(all.end(), (row.*stretches).begin(), (row.*stretches).end());
  }
  std::vector<double> held;
  for (const auto& [seed, all] : by_robot) held.push_back(floor::held_percent(all));
  return {observer, metres, held.size(), floor::mean_of(held)};
}

}  // namespace

std::vector<Region> regions_of(const std::vector<Row>& rows) {
  std::vector<Region> regions;
  for (const char* const observer : {kCalibrated, kAsGiven}) {
    regions.push_back(region_of(rows, observer, 1.0, &Row::over_1m));
    regions.push_back(region_of(rows, observer, 10.0, &Row::over_10m));
  }
  return regions;
}

std::string words_of(const std::vector<Region>& regions) {
  std::string words;
  for (const Region& region : regions) {
    words += region.observer + ", " + cell(region.metres, 0) + " m: the region of 95 % holds " +
             (std::isnan(region.held_percent) ? std::string("nothing that was measured")
                                              : cell(region.held_percent, 1) + " %") +
             ", mean of " + std::to_string(region.robots) + " robots";
    words += !region.is_judged() ? " (asked of 40 robots or more: 90 to 98)\n"
             : region.holds()    ? " (asked 90 to 98: met)\n"
                                 : " (asked 90 to 98: MISSED)\n";
  }
  return words;
}

bool is_any_missed(const std::vector<Region>& regions) {
  return std::any_of(regions.begin(), regions.end(),
                     [](const Region& region) { return region.is_judged() && !region.holds(); });
}

}  // namespace weft::evaluate::odometry
