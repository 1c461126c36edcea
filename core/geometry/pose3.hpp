#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/pose2.hpp"

namespace weft {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// Describes a pose of SE(3): takes points of frame b to frame a. The quaternion is unit.
struct Pose3 {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Pose3 inverse() const;
};
Pose3 operator*(const Pose3& a_from_b, const Pose3& b_from_c);
Eigen::Vector3d operator*(const Pose3& a_from_b, const Eigen::Vector3d& point_in_b);
bool is_finite(const Pose3& pose);

/// Return the exponential map, its inverse and the adjoint; order (translation, rotation).
Pose3 se3_exp(const Vector6d& twist);
Vector6d se3_log(const Pose3& pose);
Matrix6d adjoint(const Pose3& a_from_b);

Pose3 lift(const Pose2& pose);
/// Drops z, roll and pitch: heading is the direction of the x axis seen from above.
Pose2 project(const Pose3& pose);

}  // namespace weft
