#pragma once
#include <cmath>

#include "clients/evaluate/floor/trace.hpp"

namespace weft::evaluate::floor {

/// Returns thirty samples a second straight along x at `speed_m_s`; odometry is right.
inline Trace straight_trace(double speed_m_s, double metres) {
  Trace trace;
  const int count = static_cast<int>(std::lround(metres / speed_m_s * 30.0));
  for (int i = 0; i <= count; ++i) {
    Moment moment;
    moment.frame = static_cast<std::uint64_t>(i);
    moment.true_s = moment.sensor_s = i / 30.0;
    moment.site_from_robot = {speed_m_s * moment.true_s, 0.0, 0.0};
    moment.start_from_robot = moment.site_from_robot;
    trace.moments.push_back(moment);
  }
  return trace;
}

}  // namespace weft::evaluate::floor
