#pragma once
#include <compare>
#include <cstdint>

#include "core/ids.hpp"

namespace weft {

/// Names some places of a run that follow one another, as they are driven in one direction.
struct RunPiece {
  ExperienceId experience;
  std::uint32_t number = 0;  ///< counts the pieces of kPlacesOfPiece places each
  bool is_onward = true;     ///< towards later places
  auto operator<=>(const RunPiece&) const = default;
};
inline constexpr std::uint32_t kPlacesOfPiece = 16;

/// Tells how long a robot took for some of a piece of a run. Nothing of it is negative.
struct Pass {
  double length_m = 0.0;
  double drive_s = 0.0;
  double wait_s = 0.0;  ///< that it stood there for other robots
  bool operator==(const Pass&) const = default;
};
inline constexpr std::size_t kPassesKept = 20;  ///< most of one piece, the latest last

/// Returns the piece that a drive from one place to the next is of; over a stitch it is of the run that is left.
inline RunPiece piece_of(const PlaceId& from, const PlaceId& to) {
  const bool is_back = from.experience == to.experience && to.index < from.index;
  return {from.experience, (is_back ? to.index : from.index) / kPlacesOfPiece, !is_back};
}

}  // namespace weft
