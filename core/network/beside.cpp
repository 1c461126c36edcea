#include "core/network/beside.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/network/search.hpp"

namespace weft {
namespace {
// No more than a robot changes over to while it drives (agents/navigation/config.hpp, drivable_m and drivable_rad).
constexpr double kReach_m = 0.4;
constexpr double kReach_rad = 0.5;
constexpr std::uint32_t kHops = 4;
constexpr std::uint32_t kMostPlacesReached = 200;
}  // namespace

std::vector<PlaceId> places_beside(const Snapshot& snapshot, const PlaceId& place) {
  std::vector<std::pair<double, PlaceId>> near;
  for (const Reached& reached : breadth_first(snapshot, place, kHops, kMostPlacesReached)) {
    const double away_m = distance_m(reached.centre_from_place);
    if (reached.depth == 0 || away_m > kReach_m) continue;
    if (std::abs(wrap_angle(heading_rad(reached.centre_from_place))) > kReach_rad) continue;
    near.emplace_back(away_m, reached.id);
  }
  std::sort(near.begin(), near.end());
  std::vector<PlaceId> beside;
  beside.reserve(near.size());
  for (const auto& [away_m, id] : near) beside.push_back(id);
  return beside;
}

}  // namespace weft
