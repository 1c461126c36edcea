#pragma once
#include <Eigen/Core>

namespace weft {

/// Wraps to (-pi, pi].
double wrap_angle(double radians);

/// Describes a pose of SE(2): takes points of frame b to frame a (name values `a_from_b`). Metres, radians, REP 103.
struct Pose2 {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;

  Pose2 inverse() const;
  Eigen::Vector2d translation() const { return {x, y}; }
  bool operator==(const Pose2&) const = default;
};
Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c);
Eigen::Vector2d operator*(const Pose2& a_from_b, const Eigen::Vector2d& point_in_b);
bool is_finite(const Pose2& pose);

/// Return the exponential map of the twist (v_x, v_y, omega) over unit time, and its inverse.
Pose2 se2_exp(const Eigen::Vector3d& twist);
Eigen::Vector3d se2_log(const Pose2& pose);
/// Returns the adjoint: a_from_b * se2_exp(xi) == se2_exp(adjoint(a_from_b) * xi) * a_from_b, order (x, y, heading).
Eigen::Matrix3d adjoint(const Pose2& a_from_b);

}  // namespace weft
