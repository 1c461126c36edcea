#include "core/geometry/pose3.hpp"

#include <cmath>

namespace weft {
namespace {

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d result;
  result << 0.0, -v.z(), v.y(),  //
      v.z(), 0.0, -v.x(),        //
      -v.y(), v.x(), 0.0;
  return result;
}

Eigen::Quaterniond rotation_exp(const Eigen::Vector3d& omega) {
  const double angle = omega.norm();
  const double scale = angle > 1e-9 ? std::sin(0.5 * angle) / angle : 0.5;
  const Eigen::Vector3d axis = scale * omega;
  return Eigen::Quaterniond(std::cos(0.5 * angle), axis.x(), axis.y(), axis.z()).normalized();
}

Eigen::Vector3d rotation_log(const Eigen::Quaterniond& rotation) {
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;  // both stand for one rotation: take the shorter way
  const Eigen::Vector3d axis = sign * rotation.vec();
  const double sin_half = axis.norm();
  if (sin_half < 1e-12) return 2.0 * axis;
  return 2.0 * std::atan2(sin_half, sign * rotation.w()) / sin_half * axis;
}

}  // namespace

Pose3 Pose3::inverse() const {
  const Eigen::Quaterniond turned = rotation.conjugate();
  return {turned, -(turned * translation)};
}

Pose3 operator*(const Pose3& a_from_b, const Pose3& b_from_c) {
  return {(a_from_b.rotation * b_from_c.rotation).normalized(), a_from_b * b_from_c.translation};
}

Eigen::Vector3d operator*(const Pose3& a_from_b, const Eigen::Vector3d& point_in_b) {
  return a_from_b.rotation * point_in_b + a_from_b.translation;
}

bool is_finite(const Pose3& pose) {
  return pose.rotation.coeffs().allFinite() && pose.translation.allFinite();
}

// Rodrigues' formula and its integral V = I + (1 - cos t) / t^2 W + (t - sin t) / t^3 W^2, t = |omega|, W = [omega]x.
Pose3 se3_exp(const Vector6d& twist) {
  const Eigen::Vector3d rho = twist.head<3>();
  const Eigen::Vector3d omega = twist.tail<3>();
  const double t = omega.norm();
  double first = 0.5 - t * t / 24.0;
  double second = 1.0 / 6.0 - t * t / 120.0;
  if (t > 1e-3) {
    const double sin_half = std::sin(0.5 * t);
    first = 2.0 * sin_half * sin_half / (t * t);
    second = (t - std::sin(t)) / (t * t * t);
  }
  const Eigen::Vector3d once = omega.cross(rho);
  return {rotation_exp(omega), rho + first * once + second * omega.cross(once)};
}

// V^-1 = I - W / 2 + (1 - (t / 2) cot(t / 2)) / t^2 W^2.
Vector6d se3_log(const Pose3& pose) {
  const Eigen::Vector3d omega = rotation_log(pose.rotation);
  const double t = omega.norm();
  const double half = 0.5 * t;
  const double second = t > 1e-3 ? (1.0 - half / std::tan(half)) / (t * t) : 1.0 / 12.0 + t * t / 720.0;
  const Eigen::Vector3d once = omega.cross(pose.translation);
  Vector6d twist;
  twist << pose.translation - 0.5 * once + second * omega.cross(once), omega;
  return twist;
}

Matrix6d adjoint(const Pose3& a_from_b) {
  const Eigen::Matrix3d rotation = a_from_b.rotation.toRotationMatrix();
  Matrix6d result = Matrix6d::Zero();
  result.topLeftCorner<3, 3>() = rotation;
  result.topRightCorner<3, 3>() = skew(a_from_b.translation) * rotation;
  result.bottomRightCorner<3, 3>() = rotation;
  return result;
}

Pose3 lift(const Pose2& pose) {
  return {Eigen::Quaterniond(std::cos(0.5 * pose.heading), 0.0, 0.0, std::sin(0.5 * pose.heading)),
          {pose.x, pose.y, 0.0}};
}

Pose2 project(const Pose3& pose) {
  const Eigen::Vector3d forward = pose.rotation * Eigen::Vector3d::UnitX();
  return {pose.translation.x(), pose.translation.y(), wrap_angle(std::atan2(forward.y(), forward.x()))};
}

}  // namespace weft
