#pragma once
#include <chrono>

#include "core/time.hpp"

namespace weft::process {

/// Return what the machine's clocks say, for the edge of a process: deciding code is told the time.
inline SteadyTime steady_now() {
  return SteadyTime(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}
inline WallTime wall_now() {
  return WallTime(std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch()));
}

}  // namespace weft::process
