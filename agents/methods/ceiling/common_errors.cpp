#include "agents/methods/ceiling/common_errors.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace weft::agents {

PlanarErrors common_errors(const CeilingConfig& config, const CameraModel& camera, const CeilingScale& scale,
                           const Pose2& moved, const Eigen::Matrix2d& tilt_covariance) {
  const Eigen::Vector3d xi = se2_log(moved);
  const Eigen::Vector2d way = xi.head<2>();
  const Eigen::Vector2d across(-way.y(), way.x());
  const double turn = xi.z();
  const double away_m = scale.ceiling_m - camera.robot_from_camera.translation.z();
  const double share = std::hypot(scale.sigma_m / away_m, config.focal_share);
  PlanarErrors errors = PlanarErrors::Zero();
  errors.col(0).head<2>() = share * way;
  errors.col(1).head<2>() = config.mount_yaw_rad * across;
  // A place that is wrong by p moves by (R - 1) p as the robot turns: to first order, turn times p turned left.
  errors(1, 2) = config.mount_position_m * turn;
  errors(0, 3) = -config.mount_position_m * turn;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> parts(tilt_covariance);
  const Eigen::Matrix2d tilt = parts.eigenvectors() * parts.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const Eigen::Vector3d axis = camera.robot_from_camera.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector2d leans = axis.head<2>() / std::max(axis.z(), 0.1);
  for (int i = 0; i < 2; ++i) {
    // Pitch moves what is seen ahead, roll to the right: Ry takes up to ahead, Rx up to the right.
    const Eigen::Vector2d aside = away_m * Eigen::Vector2d(tilt(0, i), -tilt(1, i));
    const double longer = 2.0 * leans.dot(aside) / away_m;  // of a camera that leans, tilt changes the scale
    errors.col(4 + i) << -turn * aside.y() + longer * way.x(), turn * aside.x() + longer * way.y(), 0.0;
  }
  return errors;
}

}  // namespace weft::agents
