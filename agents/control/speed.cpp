#include "agents/control/speed.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {

double speed_at(const SpeedConfig& config, const Spline& path, double along_m, const TrackError& error,
                double limit_m_s) {
  const double left_m = path.length_m() - along_m;
  if (left_m <= 0.0) return 0.0;
  const double off = error.cross_track_m / config.cross_track_halves_m;
  double speed = limit_m_s / (1.0 + off * off);
  speed *= std::max(0.0, std::cos(std::min(std::abs(error.heading_rad), 1.5)));
  const double brake = 2.0 * config.deceleration_m_s2;
  const double look_m = std::min(left_m, limit_m_s * limit_m_s / brake + 0.1);
  constexpr double stride_m = 0.05;
  for (double ahead = 0.0; ahead < look_m; ahead += stride_m) {
    const double bend = std::abs(path.at(along_m + ahead).curvature_1_m);
    if (bend < 1e-3) continue;
    speed = std::min(speed, std::sqrt(config.lateral_acceleration_m_s2 / bend + brake * ahead));
  }
  speed = std::max(speed, std::min(config.slowest_m_s, limit_m_s));
  return std::min(speed, std::max(std::sqrt(brake * left_m) * 0.9, std::min(config.slowest_m_s, 2.0 * left_m)));
}

double SpeedControl::update(const SpeedConfig& config, double wanted_m_s, double measured_m_s, double elapsed_s) {
  if (wanted_m_s <= 0.0) {
    reset();
    return 0.0;
  }
  const double before_m_s = set_m_s_.value_or(std::max(0.0, measured_m_s));
  set_m_s_ = std::min(wanted_m_s, before_m_s + config.acceleration_m_s2 * elapsed_s);
  const double error = *set_m_s_ - measured_m_s;
  // While it speeds up the base lags behind; that is no lasting error.
  if (*set_m_s_ >= wanted_m_s) {
    integral_m_s_ = std::clamp(integral_m_s_ + config.integral_1_s * error * elapsed_s, -config.integral_limit_m_s,
                               config.integral_limit_m_s);
  }
  return std::max(0.0, *set_m_s_ + config.proportional * error + integral_m_s_);
}

}  // namespace weft::agents
