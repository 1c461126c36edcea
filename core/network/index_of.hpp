#pragma once
#include "core/network/network.hpp"

namespace weft {

/// Return a place's own index in its experience; of an odometry edge, that of the place it starts from.
inline std::uint32_t index_of(const Place& place) {
  return place.id.index;
}
inline std::uint32_t index_of(const Edge& edge) {
  return edge.id.a.index;
}

/// Returns whether an edge leads to the next place of its run, as odometry does.
inline bool is_hop(const EdgeId& id) {
  return id.a.experience == id.b.experience && id.b.index == id.a.index + 1;
}

}  // namespace weft
