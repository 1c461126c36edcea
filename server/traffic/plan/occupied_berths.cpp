#include "server/traffic/plan/occupied_berths.hpp"

#include <algorithm>

namespace weft::server {

void OccupiedBerths::have_driven_through(Berth berth, std::uint32_t robot) {
  auto& held = behind_.at(berth);
  if (--held[robot] == 0) held.erase(robot);
}

std::uint32_t OccupiedBerths::occupant(const BerthArc& arc, std::uint32_t robot) {
  for (const Berth berth : arc.touches) {
    const std::uint32_t other = who_stands_at(berth);
    if (other != kNobody && other != robot) return other;
    for (const auto& [behind, times] : behind_.at(berth)) {
      if (behind != robot) return behind;
    }
  }
  return kNobody;
}

void OccupiedBerths::move(const BerthArc& arc, std::uint32_t step) {
  entered_.at(arc.to) = step + 1;
  entered_.at(arc.middle) = step + 1;
  for (const Berth berth : arc.touches) passed_.at(berth) = step + 1;
}

bool OccupiedBerths::keeps_off_movers(const BerthArc& arc, std::uint32_t step) {
  return passed_.at(arc.to) != step + 1 && passed_.at(arc.middle) != step + 1 &&
         std::none_of(arc.touches.begin(), arc.touches.end(),
                      [&](Berth berth) { return entered_.at(berth) == step + 1; });
}

}  // namespace weft::server
