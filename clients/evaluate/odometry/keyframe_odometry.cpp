#include "clients/evaluate/odometry/keyframe_odometry.hpp"

#include <cmath>

#include "agents/methods/dead_reckoning.hpp"
#include "agents/methods/floor/config.hpp"

namespace weft::evaluate::odometry {

using namespace agents;

AttitudePrior vibration_alone() {
  const FloorConfig c;
  Vector6d sigma;
  sigma << c.vibration_tilt_rad, c.vibration_tilt_rad, c.vibration_height_m, c.vibration_tilt_rad,
      c.vibration_tilt_rad, c.vibration_height_m;
  AttitudePrior prior;
  prior.information = sigma.cwiseAbs2().cwiseInverse().asDiagonal();
  return prior;
}

void KeyframeOdometry::begin() {
  front_end_->begin();
  keyframe_from_robot_ = Pose2{};
  has_keyframe_ = true;
}

Step KeyframeOdometry::observe(const View* view, const Motion& motion) {
  static const FloorConfig c;
  const Step reckoned = dead_reckon(c.blind, motion, "not_found");
  const Pose2 moved = planar(reckoned.previous_from_current);
  const Pose2 expected = keyframe_from_robot_ * moved;
  keyframe_from_robot_ = expected;
  if (view == nullptr) return reckoned;
  front_end_->look(std::get<Image>(view->data));
  if (!has_keyframe_) {
    begin();
    return reckoned;
  }
  const std::optional<PlanarFit> fit = front_end_->match({expected, {}, {}});
  const Pose2 before = expected * moved.inverse();
  const Pose2 seen = fit ? before.inverse() * fit->state.a_from_b : moved;
  if (!fit || !agrees({c.wheels_share, c.wheels_m, c.wheels_rad, c.command_factor}, motion, moved, seen)) {
    begin();
    return reckoned;
  }
  keyframe_from_robot_ = fit->state.a_from_b;
  if (keyframe_from_robot_.translation().norm() > c.keyframe_m ||
      std::abs(keyframe_from_robot_.heading) > c.keyframe_rad)
    begin();
  return {Metric2{seen, fit->covariance.topLeftCorner<3, 3>()}, true, {}};
}

}  // namespace weft::evaluate::odometry
