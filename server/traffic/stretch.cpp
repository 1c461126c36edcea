#include "server/traffic/stretch.hpp"

#include <algorithm>

#include "core/network/relation.hpp"

namespace weft::server {
namespace {

bool sees(const Looked& from, const PlaceId& other, double room_m) {
  const auto found = std::lower_bound(from.around->begin(), from.around->end(), other,
                                      [](const Near& near, const PlaceId& id) { return near.place < id; });
  return found != from.around->end() && found->place == other && found->clearance_m <= room_m;
}

}  // namespace

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

Looked look(const Ground& ground, Nearness& nearness, const Touched& touched) {
  return {.touched = touched, .around = &nearness.around(ground, touched.place)};
}

std::vector<Looked> look(const Ground& ground, Nearness& nearness, const std::vector<Touched>& touched) {
  std::vector<Looked> all;
  all.reserve(touched.size());
  for (const Touched& one : touched) all.push_back(look(ground, nearness, one));
  return all;
}

bool overlap(const Looked& a, const Looked& b) {
  if (a.touched.place == b.touched.place) return true;
  const double room_m = a.touched.reach_m + b.touched.reach_m + kMargin_m;
  return sees(a, b.touched.place, room_m) || sees(b, a.touched.place, room_m);
}

bool overlap(const Ground& ground, Nearness& nearness, const std::vector<Touched>& a, const std::vector<Touched>& b) {
  const std::vector<Looked> others = look(ground, nearness, b);
  return std::any_of(a.begin(), a.end(), [&](const Touched& one) {
    const Looked here = look(ground, nearness, one);
    return std::any_of(others.begin(), others.end(), [&](const Looked& other) { return overlap(here, other); });
  });
}

}  // namespace weft::server
