#include "server/traffic/plan/cuts.hpp"

#include <optional>

namespace weft::server {

std::vector<std::uint32_t> cuts_of(const Experience& run, const CutRules& rules) {
  std::vector<std::uint32_t> cuts;
  double since_m = 0.0;
  std::optional<PlaceId> last;
  for (std::size_t i = 0; i < run.places.size(); ++i) {
    const PlaceId& here = run.places[i].id;
    const Edge* const hop = here.index == 0 ? nullptr : run.hop(here.index - 1);
    const bool begins = hop == nullptr;
    since_m = begins ? 0.0 : since_m + distance_m(hop->a_from_b);
    if (begins) last.reset();
    const bool is_far = since_m >= kMostRooms * rules.room_m;
    const bool is_clear = since_m >= rules.room_m && (!last || is_far || rules.are_clear(*last, here));
    if (begins ? rules.is_taken(here) : !is_clear) continue;
    cuts.push_back(here.index);
    since_m = 0.0;
    last = here;
  }
  return cuts;
}

}  // namespace weft::server
