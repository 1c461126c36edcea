#include "server/traffic/plan/occupied_arcs.hpp"

#include <algorithm>

namespace weft::server {

std::span<const OccupiedArcs::Arc> OccupiedArcs::next(Berth from, std::uint32_t methods) {
  while (methods >= by_methods_.size()) by_methods_.emplace_back();
  Range& range = by_methods_[methods].at(from);
  if (!range.is_known) range = look(from, methods);
  return {arcs_.data() + range.first, range.size};
}

OccupiedArcs::Range OccupiedArcs::look(Berth from, std::uint32_t methods) {
  const std::size_t first = arcs_.size();
  for (const BerthArc& arc : graph_.next(from, methods)) {
    if (!graph_.is_cut(arc.to)) continue;
    std::uint32_t occupants = 0;
    for (const Berth berth : arc.touches) {
      Known& known = berths_.at(berth);
      occupants += known.occupants;
      known.touched_by.push_back(arcs_.size());
    }
    arcs_.push_back({arc.to, occupants, arc.touches});
  }
  return {first, arcs_.size() - first, true};
}

Berth OccupiedArcs::occupied_on(const Arc& arc) {
  if (arc.occupants == 0) return kNoBerth;
  const auto is_occupied = [this](Berth berth) { return berths_.at(berth).occupants > 0; };
  const auto found = std::ranges::find_if(arc.touches, is_occupied);
  return found == arc.touches.end() ? kNoBerth : *found;
}

void OccupiedArcs::count(Berth berth, int more) {
  if (berth == kNoBerth) return;
  Known& known = berths_.at(berth);
  known.occupants += static_cast<std::uint32_t>(more);
  for (const std::size_t arc : known.touched_by) arcs_[arc].occupants += static_cast<std::uint32_t>(more);
}

}  // namespace weft::server
