#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

#include "core/network/relation.hpp"

namespace weft {
namespace {

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}
std::array<std::uint64_t, 4> numbers(const AlongPath& path) {
  return {bits(path.distance_m), bits(path.distance_variance_m2), bits(path.heading_shift_rad),
          bits(path.heading_variance_rad2)};
}
std::array<std::uint64_t, 3> numbers(const Pose2& pose) {
  return {bits(pose.x), bits(pose.y), bits(pose.heading)};
}
std::array<std::uint64_t, 7> numbers(const Pose3& pose) {
  const Eigen::Quaterniond& q = pose.rotation;
  const Eigen::Vector3d& t = pose.translation;
  return {bits(q.w()), bits(q.x()), bits(q.y()), bits(q.z()), bits(t.x()), bits(t.y()), bits(t.z())};
}

bool same_bits(const Eigen::Matrix3d& one, const Eigen::Matrix3d& other) {
  return std::equal(one.data(), one.data() + one.size(), other.data(),
                    [](double a, double b) { return bits(a) == bits(b); });
}
bool same_bits(const Covariance6& one, const Covariance6& other) {
  const Matrix6d& of_one = one.matrix();
  const Matrix6d& of_other = other.matrix();
  return &of_one == &of_other || std::equal(of_one.data(), of_one.data() + of_one.size(), of_other.data(),
                                            [](double a, double b) { return bits(a) == bits(b); });
}

template <int N>
Result<void> check_covariance(const Eigen::Matrix<double, N, N>& covariance) {
  if (!covariance.allFinite()) return fail(ErrorCode::invalid, "relation: covariance is not finite");
  const double tolerance = 1e-9 * std::max(1e-12, covariance.cwiseAbs().maxCoeff());
  if ((covariance - covariance.transpose()).cwiseAbs().maxCoeff() > tolerance) {
    return fail(ErrorCode::invalid, "relation: covariance is not symmetric");
  }
  // Most have a Cholesky factor, which takes a fraction of the time: a map of a million places is read through here.
  if (covariance.llt().info() == Eigen::Success) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(covariance, Eigen::EigenvaluesOnly);
  if (!(solver.eigenvalues().minCoeff() >= -10.0 * tolerance)) {
    return fail(ErrorCode::invalid, "relation: covariance has the negative eigenvalue " +
                                        std::to_string(solver.eigenvalues().minCoeff()) + ", must be >= 0");
  }
  return {};
}

}  // namespace

bool identical(const Relation& first, const Relation& second) {
  if (first.index() != second.index()) return false;
  return std::visit(
      [&](const auto& one) {
        const auto& other = std::get<std::decay_t<decltype(one)>>(second);
        if constexpr (std::is_same_v<std::decay_t<decltype(one)>, AlongPath>) {
          return numbers(one) == numbers(other);
        } else {
          return numbers(one.a_from_b) == numbers(other.a_from_b) && same_bits(one.covariance, other.covariance);
        }
      },
      first);
}

Result<void> check(const Relation& relation) {
  if (const auto* const flat = std::get_if<Metric2>(&relation)) {
    if (!is_finite(flat->a_from_b)) return fail(ErrorCode::invalid, "relation: pose is not finite");
    return check_covariance(flat->covariance);
  }
  if (const auto* const metric = std::get_if<Metric3>(&relation)) {
    if (!is_finite(metric->a_from_b)) return fail(ErrorCode::invalid, "relation: pose is not finite");
    const double length = metric->a_from_b.rotation.norm();
    if (!(std::abs(length - 1.0) <= 1e-6)) {
      return fail(ErrorCode::invalid,
                  "relation: quaternion has length " + std::to_string(length) + ", must be 1 within 1e-6");
    }
    return check_covariance(metric->covariance.matrix());
  }
  const auto& path = std::get<AlongPath>(relation);
  for (const double value :
       {path.distance_m, path.distance_variance_m2, path.heading_shift_rad, path.heading_variance_rad2}) {
    if (!std::isfinite(value)) return fail(ErrorCode::invalid, "relation: a number along the path is not finite");
  }
  if (path.distance_variance_m2 < 0.0 || path.heading_variance_rad2 < 0.0) {
    return fail(ErrorCode::invalid, "relation: a variance along the path is negative, must be >= 0");
  }
  return {};
}

}  // namespace weft
