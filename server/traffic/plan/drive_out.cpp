#include "server/traffic/plan/drive_out.hpp"

#include <set>
#include <vector>

namespace weft::server {
namespace {
/// Bounds how many berths are looked at.
constexpr std::size_t kLookedAt = 120;

struct Reached {
  Berth berth = kNoBerth;
  const BerthArc* first = nullptr;  ///< of the way there
};
}  // namespace

const BerthArc* drive_out(BerthGraph& graph, const WayOut& way) {
  std::set<Berth> seen = {way.from};
  std::vector<Reached> reached = {{way.from, nullptr}};
  for (std::size_t i = 0; i < reached.size() && reached.size() < kLookedAt; ++i) {
    const Reached here = reached[i];
    for (const BerthArc& arc : graph.next(here.berth, way.methods)) {
      if (!graph.is_cut(arc.to) || way.is_closed(arc) || !seen.insert(arc.to).second) continue;
      const BerthArc* const first = here.first == nullptr ? &arc : here.first;
      if (way.is_out(arc.to)) return first;
      reached.push_back({arc.to, first});
    }
  }
  return nullptr;
}

}  // namespace weft::server
