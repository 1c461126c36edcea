#include "agents/bodies/sim/base.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace weft::agents::sim {
namespace {

constexpr double kStepS = 0.005;
constexpr double kSlipMemoryS = 0.4;

double signed_size(double least, Random& random) {
  const double sign = random.chance(0.5) ? 1.0 : -1.0;
  return sign * least * random.uniform(1.0, 1.2);
}

/// Returns the next value of a first-order lag towards `target` under an acceleration limit.
double towards(double now, double target, const BaseSetup& setup, double dt_s) {
  const double lag = (target - now) * std::min(1.0, dt_s / setup.time_constant_s);
  const double limit = setup.acceleration_m_s2 * dt_s;
  const double next = now + std::clamp(lag, -limit, limit);
  constexpr double kStiction = 1e-3;
  return target == 0.0 && std::abs(next) < kStiction ? 0.0 : next;
}

}  // namespace

double distance_to_rim(const Pose2& site_from_middle, double length_m, double width_m, double x, double y) {
  const Eigen::Vector2d p = site_from_middle.inverse() * Eigen::Vector2d(x, y);
  const double beyond_x = std::abs(p.x()) - length_m / 2;
  const double beyond_y = std::abs(p.y()) - width_m / 2;
  if (beyond_x < 0.0 && beyond_y < 0.0) return std::max(beyond_x, beyond_y);
  return std::hypot(std::max(0.0, beyond_x), std::max(0.0, beyond_y));
}

double distance_to(const Box& box, double x, double y) {
  return std::max(0.0, distance_to_rim(box.site_from_box, box.length_m, box.width_m, x, y));
}

WheelErrors wheel_errors_from(const Disturbances& disturbances, Random random) {
  const double scale = 1.0 + signed_size(disturbances.wheel_scale_error, random);
  const double asymmetry = signed_size(disturbances.wheel_asymmetry, random);
  return {scale * (1.0 - asymmetry / 2), scale * (1.0 + asymmetry / 2)};
}

Base::Base(const BaseSetup& setup, const Disturbances& disturbances, const Solids& solids, const WheelErrors& wheels,
           const Pose2& site_from_robot, Random random)
    : setup_(setup),
      slip_sigma_(disturbances.slip),
      solids_(solids),
      wheels_(wheels),
      site_from_robot_(site_from_robot),
      random_(random) {}

void Base::put(const Pose2& site_from_robot, const Twist& moving) {
  site_from_robot_ = site_from_robot;
  waiting_.clear();
  in_force_ = velocity_ = moving;
  left_m_s_ = moving.linear_m_s - moving.angular_rad_s * setup_.track_m / 2;
  right_m_s_ = moving.linear_m_s + moving.angular_rad_s * setup_.track_m / 2;
  reported_ = {};
  touch_.reset();
}

void Base::advance(const Twist& command, double duration_s) {
  const int steps = std::max(1, static_cast<int>(std::ceil(duration_s / kStepS - 1e-9)));
  for (int i = 0; i < steps; ++i) {
    substep(command, duration_s / steps);
  }
}

bool Base::at_rest() const {
  const bool waits =
      std::any_of(waiting_.begin(), waiting_.end(), [](const Delayed& d) { return d.command != Twist{}; });
  return !waits && in_force_ == Twist{} && left_m_s_ == 0.0 && right_m_s_ == 0.0;
}

WheelStep Base::take_wheel_step() {
  const WheelStep taken = reported_;
  reported_ = {};
  return taken;
}

std::optional<std::string> Base::take_touch() {
  return std::exchange(touch_, std::nullopt);
}

/// Rolls to the next pose, if nothing is in the way: against something it may turn and back out; the wheels spin
/// meanwhile, as they would.
void Base::roll_to(const Pose2& next) {
  const std::string* touched = solids_.in_the_way(site_from_robot_, next);
  if (touched != nullptr) {
    velocity_.linear_m_s = 0.0;
    site_from_robot_.heading = next.heading;
  } else {
    site_from_robot_ = next;
    touched = solids_.touching(site_from_robot_);
  }
  if (touched != nullptr && !touch_) touch_ = *touched;
}

void Base::substep(const Twist& command, double dt_s) {
  now_s_ += dt_s;
  solids_.advance(site_from_robot_, dt_s);
  waiting_.push_back({now_s_ + setup_.command_delay_s, command});
  while (!waiting_.empty() && waiting_.front().due_s <= now_s_ + 1e-9) {
    in_force_ = waiting_.front().command;
    waiting_.pop_front();
  }
  const double v = std::clamp(in_force_.linear_m_s, -setup_.max_speed_m_s, setup_.max_speed_m_s);
  const double w = std::clamp(in_force_.angular_rad_s, -setup_.max_turn_rad_s, setup_.max_turn_rad_s);
  left_m_s_ = towards(left_m_s_, v - w * setup_.track_m / 2, setup_, dt_s);
  right_m_s_ = towards(right_m_s_, v + w * setup_.track_m / 2, setup_, dt_s);

  // Ornstein-Uhlenbeck: slip changes over tenths of a second, not from step to step.
  const double keep = std::exp(-dt_s / kSlipMemoryS);
  const double fresh = slip_sigma_ * std::sqrt(1.0 - keep * keep);
  left_slip_ = keep * left_slip_ + fresh * random_.normal();
  right_slip_ = keep * right_slip_ + fresh * random_.normal();
  const double left = left_m_s_ * (1.0 - left_slip_);
  const double right = right_m_s_ * (1.0 - right_slip_);
  velocity_ = {(left + right) / 2, (right - left) / setup_.track_m};

  roll_to(site_from_robot_ *
          se2_exp(Eigen::Vector3d(velocity_.linear_m_s * dt_s, 0.0, velocity_.angular_rad_s * dt_s)));
  const double rolled_left = left_m_s_ * wheels_.left_scale * dt_s;
  const double rolled_right = right_m_s_ * wheels_.right_scale * dt_s;
  reported_.distance_m += (rolled_left + rolled_right) / 2;
  reported_.heading_rad += (rolled_right - rolled_left) / setup_.track_m;
}

}  // namespace weft::agents::sim
