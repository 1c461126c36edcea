#include "server/traffic/plan/cuts.hpp"

namespace weft::server {

std::vector<std::uint32_t> cuts_of(const Experience& run, double room_m,
                                   const std::function<bool(const PlaceId&)>& is_taken) {
  std::vector<std::uint32_t> cuts;
  double since_m = 0.0;
  for (std::size_t i = 0; i < run.places.size(); ++i) {
    const PlaceId& here = run.places[i].id;
    const Edge* const hop = here.index == 0 ? nullptr : run.hop(here.index - 1);
    const bool begins = hop == nullptr;
    since_m = begins ? 0.0 : since_m + distance_m(hop->a_from_b);
    if (begins ? is_taken(here) : since_m < room_m) continue;
    cuts.push_back(here.index);
    since_m = 0.0;
  }
  return cuts;
}

}  // namespace weft::server
