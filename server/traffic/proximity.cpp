#include "server/traffic/proximity.hpp"

#include <algorithm>

#include "core/network/apart.hpp"

namespace weft::server {
namespace {

const Near* found_in(const std::vector<Near>& around, const PlaceId& place) {
  const auto found = std::lower_bound(around.begin(), around.end(), place,
                                      [](const Near& near, const PlaceId& id) { return near.place < id; });
  return found != around.end() && found->place == place ? &*found : nullptr;
}

bool sees(const LocatedPlace& from, const PlaceId& other, double room_m) {
  const Near* const found = found_in(*from.around, other);
  return found != nullptr && found->clearance_m <= room_m;
}

bool overlap_around(const LocatedPlace& a, const LocatedPlace& b) {
  if (a.touched.place == b.touched.place) return true;
  return sees(a, b.touched.place, room_m(a, b)) || sees(b, a.touched.place, room_m(a, b));
}

}  // namespace

double room_m(const LocatedPlace& a, const LocatedPlace& b) {
  return a.touched.reach_m + b.touched.reach_m + kMargin_m;
}

Eigen::AlignedBox2d box_of(const Spot& spot, double reach_m) {
  const double most_m = kLayoutSigmas * spot.sigma_m * (1.0 + spot.bend) + reach_m;
  const Eigen::Vector2d position = spot.part_from_place.translation();
  return {position - Eigen::Vector2d::Constant(most_m), position + Eigen::Vector2d::Constant(most_m)};
}

std::vector<PlaceId> Proximity::joined(const Layout::Network& network, const Batch& batch) {
  local_layouts_.joined(batch);
  layout_.joined(network, batch);
  return nearness_.joined(batch);
}

void Proximity::edited(const Layout::Network& network, const Snapshot& before) {
  forget();
  layout_.edited(network, before);
}

void Proximity::forget() {
  nearness_.forget();
  local_layouts_.forget();
  anchors_.clear();
}

const std::vector<Anchor>& Proximity::anchors(const TrafficMap& map, const PlaceId& gone) {
  const auto known = anchors_.find(gone);
  return known != anchors_.end() ? known->second : anchors_.emplace(gone, anchors_of(map, gone)).first->second;
}

LocatedPlace Proximity::locate(const TrafficMap& map, const Touched& touched) {
  LocatedPlace located{.touched = touched, .around = nearness_.around(map, touched.place), .spots = {}};
  if (map.is_in(touched.place)) {
    const std::optional<Spot> spot = layout_.spot(touched.place);
    located.is_laid = spot.has_value();
    if (spot) located.spots.push_back(*spot);
    return located;
  }
  const std::vector<Anchor>& all = anchors(map, touched.place);
  for (const Anchor& anchor : all) {
    const std::optional<Spot> spot = layout_.spot(anchor.place);
    if (!spot) continue;
    const bool is_known = std::any_of(located.spots.begin(), located.spots.end(),
                                      [&](const Spot& other) { return other.part == spot->part; });
    if (!is_known) located.spots.push_back(layout_.hung(*spot, anchor.place_from_it));
  }
  located.is_laid = all.empty() || !located.spots.empty();
  return located;
}

LocatedPlaces Proximity::locate(const TrafficMap& map, const std::vector<Touched>& touched) {
  LocatedPlaces all;
  all.places.reserve(touched.size());
  for (const Touched& one : touched) {
    all.places.push_back(locate(map, one));
    for (const Spot& spot : all.places.back().spots) all.within[spot.part].extend(box_of(spot, one.reach_m));
  }
  return all;
}

bool Proximity::are_near_by_layout(const TrafficMap& map, const LocatedPlace& a, const LocatedPlace& b) {
  for (const Spot& of_a : a.spots) {
    for (const Spot& of_b : b.spots) {
      if (!layout_.are_near(of_a, of_b, room_m(a, b))) continue;
      if (are_apart(map.now(), a.touched.place, b.touched.place)) return false;
      return !local_layouts_.are_clear(map.now(), a.touched.place, b.touched.place, room_m(a, b));
    }
  }
  return false;
}

bool Proximity::overlap(const TrafficMap& map, const LocatedPlace& a, const LocatedPlace& b) {
  return overlap_around(a, b) || are_near_by_layout(map, a, b);
}

bool Proximity::overlap(const TrafficMap& map, const LocatedPlace& a, const LocatedPlaces& others) {
  const auto meet = [&](const auto& test) { return std::any_of(others.places.begin(), others.places.end(), test); };
  if (meet([&](const LocatedPlace& b) { return overlap_around(a, b); })) return true;
  const bool may_meet = std::any_of(a.spots.begin(), a.spots.end(), [&](const Spot& spot) {
    const auto box = others.within.find(spot.part);
    return box != others.within.end() && box->second.intersects(box_of(spot, a.touched.reach_m + kMargin_m));
  });
  return may_meet && meet([&](const LocatedPlace& b) { return are_near_by_layout(map, a, b); });
}

bool Proximity::overlap(const TrafficMap& map, const std::vector<Touched>& a, const std::vector<Touched>& b) {
  const LocatedPlaces others = locate(map, b);
  return std::any_of(a.begin(), a.end(), [&](const Touched& one) { return overlap(map, locate(map, one), others); });
}

std::optional<double> Proximity::clearance_m(const LocatedPlace& a, const LocatedPlace& b) const {
  if (a.touched.place == b.touched.place) return 0.0;
  std::optional<double> least_m;
  const auto may_be = [&least_m](double clearance_m) {
    least_m = std::min(least_m.value_or(clearance_m), clearance_m);
  };
  if (const Near* const near = found_in(*a.around, b.touched.place)) may_be(near->clearance_m);
  if (const Near* const near = found_in(*b.around, a.touched.place)) may_be(near->clearance_m);
  for (const Spot& of_a : a.spots) {
    for (const Spot& of_b : b.spots) {
      if (of_a.part == of_b.part) may_be(layout_.clearance_m(of_a, of_b));
    }
  }
  return least_m;
}

std::optional<std::uint32_t> Proximity::part_of(const TrafficMap& map, const PlaceId& place) {
  if (map.is_in(place)) return layout_.part_of(place);
  for (const Anchor& anchor : anchors(map, place)) {
    if (const std::optional<std::uint32_t> part = layout_.part_of(anchor.place)) return part;
  }
  return std::nullopt;
}

std::optional<double> Proximity::farthest_m(const TrafficMap& map, const PlaceId& place, const PlaceId& other) {
  if (place == other) return 0.0;
  const Nearness::Places around = nearness_.around(map, place);
  if (const Near* const found = found_in(*around, other)) return found->clearance_m;
  const std::optional<Spot> a = layout_.spot(place);
  const std::optional<Spot> b = layout_.spot(other);
  if (!a || !b || a->part != b->part) return std::nullopt;
  const double mean_m = Layout::distance_m(*a, *b);
  return 2.0 * mean_m - layout_.clearance_m(*a, *b);
}

}  // namespace weft::server
