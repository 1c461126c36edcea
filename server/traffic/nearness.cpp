#include "server/traffic/nearness.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>
#include <utility>

#include "core/network/search.hpp"

namespace weft::server {
namespace {

constexpr std::size_t kMostPlaces = 8192;
constexpr double kSigmas = 2.0;

double clearance_m(const Relation& relation) {
  const Eigen::Matrix3d covariance = planar_covariance(relation);
  // The trace bounds the larger of the two variances.
  const double sigma_m = std::sqrt(std::max(0.0, covariance(0, 0) + covariance(1, 1)));
  return std::max(0.0, distance_m(relation) - kSigmas * sigma_m);
}

/// Returns how far to search, which is further than what counts as near: the way between two places that lie side by
/// side leads along one run to a stitch and back along the other.
double search_radius_m(double radius_m) {
  return 2 * radius_m + 1.0;
}

bool holds(const std::vector<PlaceId>& sorted, const PlaceId& place) {
  return std::binary_search(sorted.begin(), sorted.end(), place);
}

}  // namespace

Nearness::Found Nearness::search(const TrafficMap& map, const PlaceId& centre) const {
  struct Open {
    PlaceId place;
    Relation centre_from_place;
  };
  std::vector<Near> near = {{.place = centre, .clearance_m = 0.0}};
  std::set<PlaceId> seen = {centre};
  std::deque<Open> open = {{.place = centre, .centre_from_place = Metric2{}}};
  while (!open.empty() && seen.size() < kMostPlaces) {
    const Open here = open.front();
    open.pop_front();
    map.for_each_edge(here.place, [&](const Edge& edge) {
      const PlaceId next = other_end(edge, here.place);
      if (!seen.insert(next).second) return;
      const Relation edge_relation = relation_from(edge, here.place);
      const Relation relation = here.place == centre ? edge_relation : compose(here.centre_from_place, edge_relation);
      const double clearance = clearance_m(relation);
      if (clearance <= radius_m_) near.push_back({.place = next, .clearance_m = clearance});
      if (clearance <= search_radius_m(radius_m_)) open.push_back({.place = next, .centre_from_place = relation});
    });
  }
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) { return a.place < b.place; });
  return {.near = std::make_shared<const std::vector<Near>>(std::move(near)), .seen = {seen.begin(), seen.end()}};
}

Nearness::Places Nearness::around(const TrafficMap& map, const PlaceId& place) {
  const auto known = found_.find(place);
  if (known != found_.end()) return known->second.near;
  if (!map.has(place)) return std::make_shared<const std::vector<Near>>();
  return found_.emplace(place, search(map, place)).first->second.near;
}

std::vector<PlaceId> Nearness::joined(const Batch& batch) {
  std::set<PlaceId> touched;
  for (const Edge& edge : batch.edges) {
    touched.insert(edge.id.a);
    touched.insert(edge.id.b);
  }
  std::vector<PlaceId> forgotten;
  std::erase_if(found_, [&](const auto& entry) {
    const bool is_touched = std::any_of(touched.begin(), touched.end(),
                                        [&](const PlaceId& place) { return holds(entry.second.seen, place); });
    if (is_touched) forgotten.push_back(entry.first);
    return is_touched;
  });
  return forgotten;
}

bool Nearness::grow_radius(double radius_m) {
  if (radius_m <= radius_m_) return false;
  radius_m_ = radius_m;
  found_.clear();
  return true;
}

}  // namespace weft::server
