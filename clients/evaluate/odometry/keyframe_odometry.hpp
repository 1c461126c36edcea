#pragma once
#include <memory>

#include "agents/methods/method.hpp"
#include "clients/evaluate/odometry/front_end.hpp"

namespace weft::evaluate::odometry {

/// Returns the attitudes to expect from vibration alone; the mount is taken for calibrated.
agents::AttitudePrior vibration_alone();

/// Computes odometry against keyframes 0.2 m or 0.15 rad apart with any front end: the product's, but for what it has
/// learned beyond (its mount, what it rocks about) and its fallbacks. Blind steps are the wheels'.
class KeyframeOdometry {
 public:
  explicit KeyframeOdometry(std::unique_ptr<FrontEnd> front_end) : front_end_(std::move(front_end)) {}
  agents::Step observe(const agents::View* view, const agents::Motion& motion);

 private:
  void begin();

  std::unique_ptr<FrontEnd> front_end_;
  bool has_keyframe_ = false;
  Pose2 keyframe_from_robot_;
};

}  // namespace weft::evaluate::odometry
