#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "core/network/network.hpp"

namespace weft::server {

/// Cuts a run into berths: returns the indices of places at which robots can stand one behind another, each at least
/// `room_m` of driving from the one before. A chain begins with one, unless `is_taken` says that standing there is
/// standing at a berth of another run; then the first one comes `room_m` later.
std::vector<std::uint32_t> cuts_of(const Experience& run, double room_m,
                                   const std::function<bool(const PlaceId&)>& is_taken);

}  // namespace weft::server
