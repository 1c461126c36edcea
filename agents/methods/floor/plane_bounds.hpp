#pragma once
#include "agents/methods/floor/config.hpp"
#include "agents/perception/plane/consensus.hpp"
#include "agents/perception/plane/one_plane.hpp"
#include "agents/perception/plane/repetition.hpp"

namespace weft::agents {

/// Return what the settings of `floor` say of the steps that it has in common with other methods over a plane.
inline ConsensusBounds consensus_bounds(const FloorConfig& c) {
  return {.within_m = c.consensus_m, .hypotheses = c.hypotheses};
}
inline RepetitionBounds repetition_bounds(const FloorConfig& c) {
  return {.consensus = consensus_bounds(c), .most_bits = c.most_bits};
}
inline OnePlaneBounds one_plane_bounds(const FloorConfig& c) {
  return {.fewest = static_cast<std::size_t>(c.fewest_tracks),
          .fewest_share = c.fewest_tracks_share,
          .decompose_from_heights = c.decompose_from_heights,
          .motion = {c.normal_angle_rad, c.along_normal_heights}};
}

}  // namespace weft::agents
