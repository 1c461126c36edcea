#include "core/network/relation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace weft {
namespace {

template <class Matrix>
Matrix symmetric(const Matrix& matrix) {
  return 0.5 * (matrix + matrix.transpose());  // keeps rounding out of long chains
}

const Eigen::Matrix3d& full(const Eigen::Matrix3d& covariance) {
  return covariance;
}
const Matrix6d& full(const Covariance6& covariance) {
  return covariance.matrix();
}

// T_ab exp(x1) T_bc exp(x2) = T_ab T_bc exp(Ad(T_bc^-1) x1) exp(x2), to first order in the covariances.
template <class Metric>
Metric compose_metric(const Metric& ab, const Metric& bc) {
  const auto transport = adjoint(bc.a_from_b.inverse());
  const auto carried = (transport * full(ab.covariance) * transport.transpose()).eval();
  return {ab.a_from_b * bc.a_from_b, symmetric((carried + full(bc.covariance)).eval())};
}

// (T exp(x))^-1 = T^-1 exp(-Ad(T) x).
template <class Metric>
Metric inverse_metric(const Metric& ab) {
  const auto transport = adjoint(ab.a_from_b);
  return {ab.a_from_b.inverse(), symmetric((transport * full(ab.covariance) * transport.transpose()).eval())};
}

/// Returns the relation in space: a planar one says that z, roll and pitch are 0 for certain.
Metric3 raise(const Metric2& flat) {
  constexpr std::array<Eigen::Index, 3> axes{0, 1, 5};
  Matrix6d covariance = Matrix6d::Zero();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (std::size_t k = 0; k < axes.size(); ++k) {
      covariance(axes[i], axes[k]) = flat.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
    }
  }
  return {lift(flat.a_from_b), covariance};
}

/// Reads a pose along a path: by the straight-line distance, whose sign is that of the component in the direction
/// half way between both headings, so that it turns with the inverse.
AlongPath along(const Pose2& pose, const Eigen::Matrix3d& covariance) {
  const double straight = pose.translation().norm();
  const double ahead = pose.x * std::cos(0.5 * pose.heading) + pose.y * std::sin(0.5 * pose.heading);
  AlongPath result;
  result.distance_m = ahead < 0.0 ? -straight : straight;
  result.heading_shift_rad = pose.heading;
  result.heading_variance_rad2 = covariance(2, 2);
  if (straight > 0.0) {
    const Eigen::Vector2d direction_in_b = (pose.inverse() * Eigen::Vector2d::Zero()).normalized();
    result.distance_variance_m2 = direction_in_b.dot(covariance.topLeftCorner<2, 2>() * direction_in_b);
  } else {
    result.distance_variance_m2 = 0.5 * covariance.topLeftCorner<2, 2>().trace();
  }
  return result;
}
AlongPath along(const Relation& relation) {
  if (const auto* const path = std::get_if<AlongPath>(&relation)) return *path;
  return along(planar(relation), planar_covariance(relation));
}

double turn_rad(const Relation& relation) {
  if (const auto* const metric = std::get_if<Metric3>(&relation)) {
    const Eigen::Quaterniond& q = metric->a_from_b.rotation;
    return 2.0 * std::atan2(q.vec().norm(), std::abs(q.w()));
  }
  return heading_rad(relation);
}

/// Returns the Jacobian of `project` by xi in a_from_b * se3_exp(xi), read in the planar frame of b.
Eigen::Matrix<double, 3, 6> projection_jacobian(const Pose3& a_from_b) {
  const Eigen::Matrix3d rotation = a_from_b.rotation.toRotationMatrix();
  const double heading = project(a_from_b).heading;
  const Eigen::Vector2d forward{std::cos(heading), std::sin(heading)};
  const double level = rotation.topLeftCorner<2, 1>().norm();
  Eigen::Matrix<double, 3, 6> jacobian = Eigen::Matrix<double, 3, 6>::Zero();
  jacobian.block<1, 3>(0, 0) = forward.x() * rotation.row(0) + forward.y() * rotation.row(1);
  jacobian.block<1, 3>(1, 0) = -forward.y() * rotation.row(0) + forward.x() * rotation.row(1);
  if (level > 1e-9) {
    // d(R e_x) = R (omega x e_x) = omega_z R e_y - omega_y R e_z; only what is across the heading turns it.
    const Eigen::Vector2d left{-forward.y(), forward.x()};
    jacobian(2, 5) = left.dot(rotation.block<2, 1>(0, 1)) / level;
    jacobian(2, 4) = -left.dot(rotation.block<2, 1>(0, 2)) / level;
  }
  return jacobian;
}

}  // namespace

const Matrix6d& Covariance6::matrix() const {
  static const Matrix6d zero = Matrix6d::Zero();
  return matrix_ ? *matrix_ : zero;
}

Relation compose(const Relation& a_from_b, const Relation& b_from_c) {
  if (std::holds_alternative<AlongPath>(a_from_b) || std::holds_alternative<AlongPath>(b_from_c)) {
    const AlongPath ab = along(a_from_b);
    const AlongPath bc = along(b_from_c);
    return AlongPath{ab.distance_m + bc.distance_m, ab.distance_variance_m2 + bc.distance_variance_m2,
                     wrap_angle(ab.heading_shift_rad + bc.heading_shift_rad),
                     ab.heading_variance_rad2 + bc.heading_variance_rad2};
  }
  const auto* const flat_ab = std::get_if<Metric2>(&a_from_b);
  const auto* const flat_bc = std::get_if<Metric2>(&b_from_c);
  if (flat_ab != nullptr && flat_bc != nullptr) return compose_metric(*flat_ab, *flat_bc);
  const Metric3 ab = flat_ab != nullptr ? raise(*flat_ab) : std::get<Metric3>(a_from_b);
  const Metric3 bc = flat_bc != nullptr ? raise(*flat_bc) : std::get<Metric3>(b_from_c);
  return compose_metric(ab, bc);
}

Relation inverse(const Relation& a_from_b) {
  if (const auto* const path = std::get_if<AlongPath>(&a_from_b)) {
    AlongPath turned = *path;
    turned.distance_m = -path->distance_m;
    turned.heading_shift_rad = wrap_angle(-path->heading_shift_rad);
    return turned;
  }
  if (const auto* const flat = std::get_if<Metric2>(&a_from_b)) return inverse_metric(*flat);
  return inverse_metric(std::get<Metric3>(a_from_b));
}

double norm(const Relation& relation, double lever_m) {
  return std::hypot(distance_m(relation), lever_m * turn_rad(relation));
}

double distance_m(const Relation& relation) {
  if (const auto* const flat = std::get_if<Metric2>(&relation)) return std::hypot(flat->a_from_b.x, flat->a_from_b.y);
  if (const auto* const metric = std::get_if<Metric3>(&relation)) return metric->a_from_b.translation.norm();
  return std::abs(std::get<AlongPath>(relation).distance_m);
}

double heading_rad(const Relation& relation) {
  return wrap_angle(planar(relation).heading);
}

Pose2 planar(const Relation& relation) {
  if (const auto* const flat = std::get_if<Metric2>(&relation)) return flat->a_from_b;
  if (const auto* const metric = std::get_if<Metric3>(&relation)) return project(metric->a_from_b);
  const auto& path = std::get<AlongPath>(relation);
  return {path.distance_m, 0.0, path.heading_shift_rad};
}

Eigen::Matrix3d planar_covariance(const Relation& relation) {
  if (const auto* const flat = std::get_if<Metric2>(&relation)) return flat->covariance;
  if (const auto* const metric = std::get_if<Metric3>(&relation)) {
    const auto jacobian = projection_jacobian(metric->a_from_b);
    return jacobian * metric->covariance.matrix() * jacobian.transpose();
  }
  const auto& path = std::get<AlongPath>(relation);
  const Eigen::Vector2d forward_in_b{std::cos(path.heading_shift_rad), -std::sin(path.heading_shift_rad)};
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() = path.distance_variance_m2 * forward_in_b * forward_in_b.transpose();
  covariance(2, 2) = path.heading_variance_rad2;
  return covariance;
}

}  // namespace weft
