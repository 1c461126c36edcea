#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "core/network/network.hpp"

namespace weft::server {

/// Decides where a run is cut.
struct CutRules {
  double room_m = 0.0;  ///< of driving from one cut to the next, at least
  /// Returns whether robots can stand at both, as far as is known where these lie: a run may turn back.
  std::function<bool(const PlaceId&, const PlaceId&)> are_clear;
  /// Returns whether standing there is standing at a berth of another run.
  std::function<bool(const PlaceId&)> is_taken;
};

/// Bounds how many rooms a run may turn back without a cut.
inline constexpr double kMostRooms = 3.0;

/// Cuts a run into berths: returns the indices of places at which robots can stand one behind another. A chain begins
/// with one, unless it is taken; then the first one comes a room later.
std::vector<std::uint32_t> cuts_of(const Experience& run, const CutRules& rules);

}  // namespace weft::server
