#pragma once
#include <algorithm>
#include <cmath>
#include <deque>

#include "agents/perception/motion.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::test {

/// Describes a differential-drive base as tests need it: first-order lag, transport delay, and drive that slips.
struct UnicycleConfig {
  double lag_s = 0.12;
  int delay_samples = 1;
  double slip = 0.0;           ///< share of the commanded speed that is lost
  double turn_slip = 0.0;      ///< the same of the turn rate
  double drift_rad_per_m = 0;  ///< asymmetric wheels
};

class Unicycle {
 public:
  Unicycle(const UnicycleConfig& config, const Pose2& start) : config_(config), pose_(start) {}

  void drive(const agents::Twist& command, double elapsed_s) {
    waiting_.push_back(command);
    if (static_cast<int>(waiting_.size()) <= config_.delay_samples) return;
    const agents::Twist asked = waiting_.front();
    waiting_.pop_front();
    const double answer = config_.lag_s > 0.0 ? 1.0 - std::exp(-elapsed_s / config_.lag_s) : 1.0;
    now_.linear_m_s += answer * (asked.linear_m_s - now_.linear_m_s);
    now_.angular_rad_s += answer * (asked.angular_rad_s - now_.angular_rad_s);
    const double distance = now_.linear_m_s * (1.0 - config_.slip) * elapsed_s;
    const double turn =
        now_.angular_rad_s * (1.0 - config_.turn_slip) * elapsed_s + config_.drift_rad_per_m * distance;
    step_ = se2_exp({distance, 0.0, turn});
    pose_ = pose_ * step_;
  }

  const Pose2& world_from_robot() const { return pose_; }
  /// Returns the base's motion in the last `drive`.
  const Pose2& last_step() const { return step_; }
  /// Returns what the wheels turned, slip and all.
  const agents::Twist& wheels() const { return now_; }

 private:
  UnicycleConfig config_;
  Pose2 pose_;
  Pose2 step_;
  agents::Twist now_;
  std::deque<agents::Twist> waiting_;
};

}  // namespace weft::test
