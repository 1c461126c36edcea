#pragma once
#include <chrono>
#include <cstdint>

namespace weft {

using Duration = std::chrono::nanoseconds;

namespace detail {
/// Clocks without now(): deciding code is told the time, it never asks.
struct SteadyTag {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  static constexpr bool is_steady = true;
};
struct SensorTag : SteadyTag {};
struct WallTag : SteadyTag {
  static constexpr bool is_steady = false;
};
}  // namespace detail

/// This process's monotonic clock: intervals, timers, silence. Never sent, never compared across machines.
using SteadyTime = std::chrono::time_point<detail::SteadyTag, Duration>;
/// A body's own clock: stamps views and odometry.
using SensorTime = std::chrono::time_point<detail::SensorTag, Duration>;
/// UTC since 1970: for records that people read, and for measuring skew. Never decides.
using WallTime = std::chrono::time_point<detail::WallTag, Duration>;

inline double seconds(Duration d) {
  return std::chrono::duration<double>(d).count();
}
inline Duration from_seconds(double s) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s));
}

}  // namespace weft
