#pragma once
#include <chrono>
#include <cstdint>

namespace weft {

using Duration = std::chrono::nanoseconds;

namespace detail {
/// Stands for a clock without now(): deciding code is told the time, it never asks.
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

/// Tells this process's monotonic time: intervals, timers, silence. Never sent, never compared across machines.
using SteadyTime = std::chrono::time_point<detail::SteadyTag, Duration>;
/// Tells the time of a body's own clock, which stamps views and odometry.
using SensorTime = std::chrono::time_point<detail::SensorTag, Duration>;
/// Tells UTC since 1970: for records that people read, and for measuring skew. Nothing is decided by it.
using WallTime = std::chrono::time_point<detail::WallTag, Duration>;

inline double seconds(Duration d) {
  return std::chrono::duration<double>(d).count();
}
inline Duration from_seconds(double s) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s));
}

}  // namespace weft
