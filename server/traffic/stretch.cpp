#include "server/traffic/stretch.hpp"

#include <algorithm>

#include "core/network/relation.hpp"

namespace weft::server {

std::vector<Touched> touched_by(const Route& route, std::uint32_t from, std::uint32_t to, double footprint_m) {
  std::vector<Touched> touched;
  if (route.places.empty()) return touched;
  const auto last = static_cast<std::uint32_t>(route.places.size() - 1);
  for (std::uint32_t i = from; i <= std::min(to, last); ++i) {
    double slack = kLeastSlack_m;
    if (i > 0) slack = std::max(slack, distance_m(route.relations[i - 1]) / 2);
    if (i < last) slack = std::max(slack, distance_m(route.relations[i]) / 2);
    touched.push_back({.place = route.places[i], .reach_m = footprint_m + slack});
  }
  return touched;
}

}  // namespace weft::server
