#pragma once
#include "agents/perception/rig.hpp"
#include "agents/perception/sample.hpp"
#include "agents/perception/stereo/stereo_odometry.hpp"
#include "core/result.hpp"

namespace weft::evaluate::topometric {

/// Follows a robot by its pair and nothing else, as Dayoub et al. (2013, IV-D) draw it beside their open odometry:
/// while vision fails the robot stands where it is, and whatever a view says is believed. It exists in this study
/// alone.
class RawOdometry {
 public:
  /// Errors of StereoOdometry::make.
  static Result<RawOdometry> make(const agents::StereoOdometryConfig& config, const agents::Sensor& sensor);

  /// Takes the next sample of the body.
  void take(const agents::Sample& sample);
  const Pose2& start_from_robot() const { return start_from_robot_; }

 private:
  explicit RawOdometry(agents::StereoOdometry stereo) : stereo_(std::move(stereo)) {}

  agents::StereoOdometry stereo_;
  agents::StereoOdometry::State state_;
  Pose2 start_from_robot_;
};

}  // namespace weft::evaluate::topometric
