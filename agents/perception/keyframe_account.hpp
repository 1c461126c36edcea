#pragma once
#include <Eigen/Core>
#include <optional>

#include "agents/perception/motion.hpp"
#include "agents/perception/planar_motion.hpp"
#include "core/geometry/pose2.hpp"

/// Keeps the account of what views tell against a keyframe, for methods that see their motion over a plane.
namespace weft::agents {

/// Returns the covariance of a_from_b * b_from_c of which only the first is uncertain.
Eigen::Matrix3d carried(const Eigen::Matrix3d& of_a_from_b, const Pose2& b_from_c);

/// Describes the attitude of any one view as far as it is known: the mount's tilt as far as it has been found, and
/// vibration. Height cannot be seen in one camera's motion: it is held by the calibration.
struct KnownAttitude {
  Eigen::Vector3d mean;
  Eigen::Matrix3d shared;  ///< covariance that all views have in common
  Eigen::Matrix3d own;     ///< and each its own
};

/// Returns what is known of the keyframe's attitude and the newest view's before they are compared. `told` is the
/// information on the keyframe's that earlier fits gave, `pull` its product with the mean.
AttitudePrior prior_of_views(const KnownAttitude& known, const Eigen::Matrix3d& told, const Eigen::Vector3d& pull);

/// Returns what a fit has told of its newer view's attitude, for when that becomes the keyframe. Not all of it: fits
/// of the same corners err alike, and what is passed on in full from keyframe to keyframe drags the tilt away (1.3 %
/// of speed on pale floors).
Eigen::Matrix3d told_of_attitude(const KnownAttitude& known, const Eigen::Matrix3d& fitted_covariance);

/// Returns the covariance of a step by itself, and adds it to the keyframe's account. Composed step by step, the
/// covariances come to the fit's as long as a keyframe lasts (what has been said too much, as of blind steps, cannot
/// be taken back), and from keyframe to keyframe they add up. On top comes what all steps have in common
/// (docs/decisions/024-odometry-candidates.md).
Eigen::Matrix3d own_step_covariance(const PlanarFit& fit, const Pose2& moved, Eigen::Matrix3d& keyframe_covariance);

/// Adds what the wheels have turned to `wheels`, the robot's motion by them; none once they were not reported.
void roll(const Motion& motion, std::optional<Pose2>& wheels);

}  // namespace weft::agents
