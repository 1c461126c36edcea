#include "core/geometry/pose2.hpp"

#include <cmath>
#include <numbers>

namespace weft {

double wrap_angle(double radians) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double size = std::abs(radians);
  if (size < std::numbers::pi) return radians;
  // Up to two turns a difference is exact (Sterbenz), and so the same as the far slower remainder.
  const double wrapped = size < 1.5 * turn ? radians - std::copysign(turn, radians) : std::remainder(radians, turn);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

Pose2 Pose2::inverse() const {
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  return {-c * x - s * y, s * x - c * y, wrap_angle(-heading)};
}

Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c) {
  const Eigen::Vector2d origin = a_from_b * b_from_c.translation();
  return {origin.x(), origin.y(), wrap_angle(a_from_b.heading + b_from_c.heading)};
}

Eigen::Vector2d operator*(const Pose2& a_from_b, const Eigen::Vector2d& point_in_b) {
  const double c = std::cos(a_from_b.heading);
  const double s = std::sin(a_from_b.heading);
  return {c * point_in_b.x() - s * point_in_b.y() + a_from_b.x, s * point_in_b.x() + c * point_in_b.y() + a_from_b.y};
}

bool is_finite(const Pose2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

// Closed forms for a constant twist: V(omega) = [s -c; c s] with s = sin(omega) / omega, c = (1 - cos(omega)) /
// omega.
Pose2 se2_exp(const Eigen::Vector3d& twist) {
  const double omega = twist.z();
  double s = 1.0;
  double c = 0.5 * omega;
  if (std::abs(omega) > 1e-9) {
    const double sin_half = std::sin(0.5 * omega);
    s = std::sin(omega) / omega;
    c = 2.0 * sin_half * sin_half / omega;  // 1 - cos without cancellation
  }
  return {s * twist.x() - c * twist.y(), c * twist.x() + s * twist.y(), wrap_angle(omega)};
}

Eigen::Vector3d se2_log(const Pose2& pose) {
  const double omega = wrap_angle(pose.heading);
  const double half = 0.5 * omega;
  const double a = std::abs(omega) > 1e-5 ? half / std::tan(half) : 1.0 - omega * omega / 12.0;
  return {a * pose.x + half * pose.y, -half * pose.x + a * pose.y, omega};
}

Eigen::Matrix3d adjoint(const Pose2& a_from_b) {
  const double c = std::cos(a_from_b.heading);
  const double s = std::sin(a_from_b.heading);
  Eigen::Matrix3d result;
  result << c, -s, a_from_b.y,  //
      s, c, -a_from_b.x,        //
      0.0, 0.0, 1.0;
  return result;
}

}  // namespace weft
