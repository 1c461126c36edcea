#include "server/traffic/nearness.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>

#include "core/network/search.hpp"

namespace weft::server {
namespace {

constexpr std::size_t kMostPlaces = 512;
constexpr double kSigmas = 2.0;

double clearance_m(const Relation& relation) {
  const Eigen::Matrix3d covariance = planar_covariance(relation);
  // The trace bounds the larger of the two variances.
  const double sigma_m = std::sqrt(std::max(0.0, covariance(0, 0) + covariance(1, 1)));
  return std::max(0.0, distance_m(relation) - kSigmas * sigma_m);
}

std::vector<Near> search(const Snapshot& snapshot, const PlaceId& centre, double radius_m) {
  struct Open {
    PlaceId place;
    Relation centre_from_place;
  };
  std::vector<Near> found = {{.place = centre, .clearance_m = 0.0}};
  std::set<PlaceId> seen = {centre};
  std::deque<Open> open = {{.place = centre, .centre_from_place = Metric2{}}};
  while (!open.empty() && found.size() < kMostPlaces) {
    const Open here = open.front();
    open.pop_front();
    snapshot.for_each_edge(here.place, [&](const Edge& edge) {
      const PlaceId next = other_end(edge, here.place);
      if (!seen.insert(next).second) return;
      const Relation edge_relation = relation_from(edge, here.place);
      const Relation relation = here.place == centre ? edge_relation : compose(here.centre_from_place, edge_relation);
      const double clearance = clearance_m(relation);
      if (clearance > radius_m) return;
      found.push_back({.place = next, .clearance_m = clearance});
      open.push_back({.place = next, .centre_from_place = relation});
    });
  }
  std::sort(found.begin(), found.end(), [](const Near& a, const Near& b) { return a.place < b.place; });
  return found;
}

bool holds(const std::vector<Near>& found, const PlaceId& place) {
  return std::binary_search(found.begin(), found.end(), Near{.place = place},
                            [](const Near& a, const Near& b) { return a.place < b.place; });
}

}  // namespace

const std::vector<Near>& Nearness::around(const Snapshot& snapshot, const PlaceId& place) {
  const auto known = found_.find(place);
  if (known != found_.end()) return known->second;
  static const std::vector<Near> nothing;
  if (snapshot.place(place) == nullptr) return nothing;
  return found_.emplace(place, search(snapshot, place, radius_m_)).first->second;
}

void Nearness::joined(const Batch& batch) {
  std::set<PlaceId> touched;
  for (const Edge& edge : batch.edges) {
    touched.insert(edge.id.a);
    touched.insert(edge.id.b);
  }
  std::erase_if(found_, [&](const auto& entry) {
    return std::any_of(touched.begin(), touched.end(),
                       [&](const PlaceId& place) { return holds(entry.second, place); });
  });
}

void Nearness::look_at_least(double radius_m) {
  if (radius_m <= radius_m_) return;
  radius_m_ = radius_m;
  found_.clear();
}

}  // namespace weft::server
