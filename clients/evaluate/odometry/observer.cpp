#include "clients/evaluate/odometry/observer.hpp"

namespace weft::evaluate::odometry {

using namespace agents;

void Observer::take(const Sample& sample) {
  since_.elapsed += sample.motion.elapsed;
  since_.command = sample.motion.command;
  has_wheels_ = has_wheels_ && sample.motion.wheels.has_value();
  if (has_wheels_) {
    const WheelStep before = since_.wheels.value_or(WheelStep{});
    since_.wheels = WheelStep{before.distance_m + sample.motion.wheels->distance_m,
                              before.heading_rad + sample.motion.wheels->heading_rad};
  } else {
    since_.wheels.reset();
  }
  if (samples_++ % every_ != 0) return;
  const double began_s = cpu_s_();
  const Step step = observe_(sample.of({}), since_);
  spent_s_ += cpu_s_() - began_s;
  ++views_;
  since_ = {};
  has_wheels_ = true;
  start_from_robot_ = start_from_robot_ * planar(step.previous_from_current);
  floor::Moment moment;
  moment.frame = sample.frame;
  moment.sensor_s = seconds(sample.time.time_since_epoch());
  moment.start_from_robot = start_from_robot_;
  moment.step_covariance = planar_covariance(step.previous_from_current);
  moment.step_common = step.common;
  moment.seen = step.seen;
  trace_.moments.push_back(moment);
  if (!step.seen) ++trace_.refusals[std::string(step.blind_reason)];
}

}  // namespace weft::evaluate::odometry
