#pragma once
#include <algorithm>
#include <chrono>
#include <cstddef>

#include "core/time.hpp"

namespace weft::server {

/// Bound the wait before what is not answered is repeated: the first one, then twice as long each time, up to the
/// last.
inline constexpr Duration kFirstRepeat = std::chrono::milliseconds(500);
inline constexpr Duration kLastRepeat = std::chrono::seconds(4);
inline Duration next_wait(Duration wait) {
  return wait == Duration{} ? kFirstRepeat : std::min(wait * 2, kLastRepeat);
}

/// Bounds the peers whose wishes are remembered; more are not listened to.
inline constexpr std::size_t kMostPeers = 1024;

}  // namespace weft::server
