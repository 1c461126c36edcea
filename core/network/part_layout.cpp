#include "core/network/part_layout.hpp"

#include <algorithm>
#include <utility>

#include "core/network/search.hpp"

namespace weft {
namespace {

/// Counts for an edge that states no uncertainty, so that of two ways the one with fewer such edges is taken.
constexpr double kLeastVariance_m2 = 1e-8;

double variance_m2(const Relation& relation) {
  const Eigen::Matrix3d covariance = planar_covariance(relation);
  const double stated = covariance(0, 0) + covariance(1, 1);
  return std::max(kLeastVariance_m2, stated);
}

}  // namespace

NetworkView view_of(const std::shared_ptr<const Snapshot>& snapshot) {
  return {
      [snapshot](const PlaceId& place) { return snapshot->place(place) != nullptr; },
      [snapshot](const PlaceId& place, const NetworkView::Visit& visit) { snapshot->for_each_edge(place, visit); }};
}

NetworkView view_of(const Window& window) {
  return {[&window](const PlaceId& place) { return window.place(place) != nullptr; },
          [&window](const PlaceId& place, const NetworkView::Visit& visit) { window.for_each_edge(place, visit); }};
}

void PlacePoses::put(const PlaceId& place, const Pose2& pose) {
  Chunk& chunk = chunks_[{place.experience, place.index / kChunk}];
  const std::uint32_t at = place.index % kChunk;
  chunk.filled |= std::uint64_t{1} << at;
  chunk.poses[at] = pose;
  ++size_;
}

const Pose2* PlacePoses::find(const PlaceId& place) const {
  const auto chunk = chunks_.find({place.experience, place.index / kChunk});
  if (chunk == chunks_.end()) return nullptr;
  const std::uint32_t at = place.index % kChunk;
  return (chunk->second.filled >> at & 1U) == 0 ? nullptr : &chunk->second.poses[at];
}

PartLayout::PartLayout(NetworkView network, const PlaceId& root) : network_(std::move(network)) {
  open_.push({0.0, root, root, {}});
}

bool PartLayout::step(std::size_t ways) {
  for (; ways > 0 && !open_.empty(); --ways) {
    const Open nearest = open_.top();
    open_.pop();
    if (poses_.find(nearest.place) != nullptr) continue;
    poses_.put(nearest.place, nearest.root_from_place);
    network_.for_each_edge(nearest.place, [&](const Edge& edge) {
      const PlaceId next = other_end(edge, nearest.place);
      if (poses_.find(next) != nullptr || !network_.has(next)) return;
      const Relation relation = relation_from(edge, nearest.place);
      open_.push({nearest.variance + variance_m2(relation), next, nearest.place,
                  nearest.root_from_place * planar(relation)});
    });
  }
  return !open_.empty();
}

}  // namespace weft
