#pragma once
#include <Eigen/Core>
#include <string_view>

#include "agents/methods/method.hpp"
#include "agents/perception/keyframe_account.hpp"
#include "agents/perception/mount.hpp"
#include "agents/perception/planar_motion.hpp"

/// Holds what methods that follow a plane have in common from view to view: their odometries name the keyframe's
/// account and the attitude alike, and their configurations the vibration.
namespace weft::agents {

/// Returns the fallback's step, adding it to the keyframe's account: the next tracked view takes its error back.
template <class Odometry>
Step blind(Odometry& s, const Step& reckoned, std::string_view reason) {
  s.keyframe_from_robot = s.keyframe_from_robot * planar(reckoned.previous_from_current);
  s.keyframe_covariance = carried(s.keyframe_covariance, planar(reckoned.previous_from_current)) +
                          planar_covariance(reckoned.previous_from_current);
  return {reckoned.previous_from_current, false, reason};
}

/// Returns the fallback's step from a view in which nothing was followed. The mount's tilt is still known, this
/// view's vibration is not.
template <class Odometry>
Step out_of_sight(Odometry& s, const Step& reckoned, std::string_view reason) {
  Step step = blind(s, reckoned, reason);
  s.inliers = 0;
  const MountTilt tilt = s.mount->tilt();
  s.attitude = {tilt.pitch_rad, tilt.roll_rad, 0.0};
  s.keyframe_told.setZero();
  s.keyframe_pull.setZero();
  return step;
}

/// Returns what is known of every view's attitude: the mount's tilt, and how far it vibrates.
template <class Config, class Odometry>
KnownAttitude known_attitude(const Config& c, const Odometry& s) {
  const MountTilt tilt = s.mount->tilt();
  KnownAttitude known{{tilt.pitch_rad, tilt.roll_rad, 0.0}, Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};
  known.shared.template topLeftCorner<2, 2>() = tilt.covariance;
  known.own.diagonal() =
      Eigen::Vector3d(c.vibration_tilt_rad, c.vibration_tilt_rad, c.vibration_height_m).cwiseAbs2();
  return known;
}

/// Returns what is known of the keyframe's attitude and the newest view's before the view is fitted.
template <class Config, class Odometry>
AttitudePrior view_prior(const Config& c, const Odometry& s) {
  return prior_of_views(known_attitude(c, s), s.keyframe_told, s.keyframe_pull);
}

/// Keeps what the newest view's fit has told of its attitude, for when it becomes the keyframe.
template <class Config, class Odometry>
void tell_keyframe(const Config& c, Odometry& s) {
  s.keyframe_told = told_of_attitude(known_attitude(c, s), s.attitude_covariance);
  s.keyframe_pull = s.keyframe_told * s.attitude.vector();
}

/// Returns a step's covariance: what the keyframe accounts for, and what all steps have in common.
template <class Odometry>
Eigen::Matrix3d step_covariance(const PlanarFit& fit, const Pose2& moved, const PlanarErrors& common, Odometry& s) {
  Eigen::Matrix3d covariance = own_step_covariance(fit, moved, s.keyframe_covariance);
  covariance += common * common.transpose();
  covariance += 1e-14 * Eigen::Matrix3d::Identity();  // standing still is certain, but not singular
  return covariance;
}

}  // namespace weft::agents
