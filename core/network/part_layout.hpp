#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/network/network.hpp"
#include "core/network/window.hpp"

namespace weft {

/// Reads a network for whoever lays it out, be it a snapshot or a window.
struct NetworkView {
  using Visit = std::function<void(const Edge&)>;
  std::function<bool(const PlaceId&)> has;
  std::function<void(const PlaceId&, const Visit&)> for_each_edge;
};
/// Return a view that keeps the snapshot, or one of a window that has to outlive it.
NetworkView view_of(const std::shared_ptr<const Snapshot>& snapshot);
NetworkView view_of(const Window& window);

/// Maps places to poses, in chunks: 100,000 of them are quick to write, to find and to let go.
class PlacePoses {
 public:
  /// Puts the pose of a place that has none yet.
  void put(const PlaceId& place, const Pose2& pose);
  /// Returns null for a place that has none.
  const Pose2* find(const PlaceId& place) const;
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// Calls `visit(const PlaceId&, const Pose2&)` in the order of places.
  template <class Visit>
  void for_each(Visit&& visit) const;

 private:
  static constexpr std::uint32_t kChunk = 64;
  struct Key {
    ExperienceId experience;
    std::uint32_t chunk = 0;
    auto operator<=>(const Key&) const = default;
  };
  struct Chunk {
    std::uint64_t filled = 0;  ///< a bit a pose
    std::array<Pose2, kChunk> poses{};
  };
  std::map<Key, Chunk> chunks_;
  std::size_t size_ = 0;
};

/// Lays out the part of a network that is joined to one place, in that place's frame: each place along the chain of
/// edges that leaves the least variance of its position (a spanning tree, by Dijkstra), and of ways that leave the
/// same the one over the lowest place, so that the network alone determines the layout. The error with which a loop
/// does not close is not spread over it.
class PartLayout {
 public:
  PartLayout(NetworkView network, const PlaceId& root);
  /// Looks at up to so many ways, each of which lays a place or leads to one that is laid already; returns whether
  /// more are left.
  bool step(std::size_t ways);
  const PlacePoses& root_from_place() const { return poses_; }
  PlacePoses take() { return std::move(poses_); }

 private:
  struct Open {
    double variance = 0.0;
    PlaceId place;
    PlaceId from;  ///< the place before on the way
    Pose2 root_from_place;
    bool operator>(const Open& other) const {
      return std::tie(variance, place, from) > std::tie(other.variance, other.place, other.from);
    }
  };
  NetworkView network_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
  PlacePoses poses_;
};

template <class Visit>
void PlacePoses::for_each(Visit&& visit) const {
  for (const auto& [key, chunk] : chunks_) {
    for (std::uint32_t at = 0; at < kChunk; ++at) {
      if ((chunk.filled >> at & 1U) == 0) continue;
      visit(PlaceId{key.experience, key.chunk * kChunk + at}, chunk.poses[at]);
    }
  }
}

}  // namespace weft
