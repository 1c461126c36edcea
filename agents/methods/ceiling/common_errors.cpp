#include "agents/methods/ceiling/common_errors.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "agents/perception/mount_drive.hpp"

namespace weft::agents {

PlanarErrors common_errors(const CeilingConfig& config, const CameraModel& camera, const CeilingScale& scale,
                           const Pose2& moved, const Eigen::Matrix2d& tilt_covariance) {
  const Eigen::Vector3d xi = se2_log(moved);
  const Eigen::Vector2d way = xi.head<2>();
  const Eigen::Vector2d across(-way.y(), way.x());
  const double turn = xi.z();
  const double away_m = scale.ceiling_m - camera.robot_from_camera.translation.z();
  const double share = std::hypot(scale.sigma_m / away_m, config.focal_share, kCeilingScale);
  PlanarErrors errors = PlanarErrors::Zero();
  errors.col(0).head<2>() = share * way;
  errors.col(1).head<2>() = config.mount_yaw_rad * across;
  // A place that is wrong by p moves by (R - 1) p as the robot turns: to first order, turn times p turned left.
  errors(1, 2) = config.mount_position_m * turn;
  errors(0, 3) = -config.mount_position_m * turn;
  const double hanging2 = kHangingTiltRad * kHangingTiltRad;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> parts(tilt_covariance +
                                                             hanging2 * Eigen::Matrix2d::Identity());
  const Eigen::Matrix2d tilt = parts.eigenvectors() * parts.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const Eigen::Vector3d axis = camera.robot_from_camera.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector2d middle = axis.head<2>() / std::max(axis.z(), 0.1);  // of the view, from above the camera
  for (int i = 0; i < 2; ++i) {
    // Pitch moves what is seen ahead, roll to the right: Ry takes up to ahead, Rx up to the right.
    const Eigen::Vector2d aside(tilt(0, i), -tilt(1, i));
    // A point at p is put at p + aside + p (p . aside), so that over a way it moves by (way aside^T + way . aside)
    // p more: a turn, and of a camera that leans another way, as the middle of the view is not above it.
    const Eigen::Matrix2d outer = way * aside.transpose();
    const Eigen::Vector2d farther =
        (0.5 * (outer + outer.transpose()) + way.dot(aside) * Eigen::Matrix2d::Identity()) * middle;
    const double turned = 0.5 * (outer(1, 0) - outer(0, 1)) / away_m;
    errors.col(4 + i) << -turn * away_m * aside.y() - farther.x(), turn * away_m * aside.x() - farther.y(), -turned;
  }
  return errors;
}

}  // namespace weft::agents
