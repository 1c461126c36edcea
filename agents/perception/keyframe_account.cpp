#include "agents/perception/keyframe_account.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

namespace weft::agents {
namespace {

/// Returns a symmetric matrix with its negative eigenvalues set to zero.
Eigen::Matrix3d positive_part(const Eigen::Matrix3d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(0.5 * (matrix + matrix.transpose()));
  const Eigen::Matrix3d& axes = parts.eigenvectors();
  return axes * parts.eigenvalues().cwiseMax(0.0).asDiagonal() * axes.transpose();
}

Eigen::Matrix3d inverse_of(const Eigen::Matrix3d& covariance) {
  return covariance.ldlt().solve(Eigen::Matrix3d::Identity());
}

}  // namespace

Eigen::Matrix3d carried(const Eigen::Matrix3d& of_a_from_b, const Pose2& b_from_c) {
  const Eigen::Matrix3d transport = adjoint(b_from_c.inverse());
  return transport * of_a_from_b * transport.transpose();
}

AttitudePrior prior_of_views(const KnownAttitude& known, const Eigen::Matrix3d& told, const Eigen::Vector3d& pull) {
  Matrix6d covariance;
  covariance << known.shared + known.own, known.shared, known.shared, known.shared + known.own;
  AttitudePrior prior;
  prior.information = covariance.ldlt().solve(Matrix6d::Identity());
  Vector6d pulled;
  pulled << known.mean, known.mean;
  pulled = prior.information * pulled;
  prior.information.topLeftCorner<3, 3>() += told;
  pulled.head<3>() += pull;
  prior.mean = prior.information.ldlt().solve(pulled);
  return prior;
}

Eigen::Matrix3d told_of_attitude(const KnownAttitude& known, const Eigen::Matrix3d& fitted_covariance) {
  constexpr double kToldShare = 0.8;
  return kToldShare * positive_part(inverse_of(fitted_covariance) - inverse_of(known.shared + known.own));
}

Eigen::Matrix3d own_step_covariance(const PlanarFit& fit, const Pose2& moved, Eigen::Matrix3d& keyframe_covariance) {
  // Fits of the same corners err alike, the more the worse corners are to be followed: blurred, or pale.
  const double alike = 0.24 * std::clamp(fit.scale * fit.scale, 0.25, 5.0);
  constexpr double heading_drift = 0.00033;  // rad over a metre, growing by its root, however sharp the plane
  const Eigen::Matrix3d before = carried(keyframe_covariance, moved);
  Eigen::Matrix3d covariance = positive_part(alike * fit.covariance.topLeftCorner<3, 3>() - before);
  keyframe_covariance = before + covariance;
  covariance(2, 2) += heading_drift * heading_drift * moved.translation().norm();
  return covariance;
}

void roll(const Motion& motion, std::optional<Pose2>& wheels) {
  if (!motion.wheels.has_value()) wheels.reset();
  if (wheels.has_value())
    wheels = *wheels * se2_exp(Eigen::Vector3d(motion.wheels->distance_m, 0.0, motion.wheels->heading_rad));
}

}  // namespace weft::agents
