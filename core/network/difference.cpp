#include "core/network/difference.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

double turned_rad(const Pose3& pose) {
  return 2.0 * std::atan2(pose.rotation.vec().norm(), std::abs(pose.rotation.w()));
}

struct Pair3 {
  const Metric3* a;
  const Metric3* b;
  explicit operator bool() const { return a != nullptr && b != nullptr; }
};
Pair3 in_space(const Relation& a, const Relation& b) {
  return {std::get_if<Metric3>(&a), std::get_if<Metric3>(&b)};
}

}  // namespace

Difference difference(const Relation& a, const Relation& b) {
  if (const Pair3 both = in_space(a, b)) {
    const Pose3 apart = both.a->a_from_b.inverse() * both.b->a_from_b;
    return {apart.translation.norm(), turned_rad(apart)};
  }
  const Pose2 apart = planar(a).inverse() * planar(b);
  return {apart.translation().norm(), std::abs(wrap_angle(apart.heading))};
}

double sigmas_apart(const Relation& a, const Relation& b, double floor_m, double floor_rad) {
  const double floor_m2 = floor_m * floor_m;
  const double floor_rad2 = floor_rad * floor_rad;
  if (const Pair3 both = in_space(a, b)) {
    const Vector6d apart = se3_log(both.a->a_from_b.inverse() * both.b->a_from_b);
    Matrix6d covariance = both.a->covariance.matrix() + both.b->covariance.matrix();
    covariance.diagonal().head<3>().array() += floor_m2;
    covariance.diagonal().tail<3>().array() += floor_rad2;
    return std::sqrt(std::max(0.0, apart.dot(covariance.ldlt().solve(apart))));
  }
  const Eigen::Vector3d apart = se2_log(planar(a).inverse() * planar(b));
  Eigen::Matrix3d covariance = planar_covariance(a) + planar_covariance(b);
  covariance.diagonal() += Eigen::Vector3d(floor_m2, floor_m2, floor_rad2);
  return std::sqrt(std::max(0.0, apart.dot(covariance.ldlt().solve(apart))));
}

Difference spread_of(const Relation& relation) {
  if (const auto* const metric = std::get_if<Metric3>(&relation)) {
    const Vector6d variances = metric->covariance.matrix().diagonal();
    return {std::sqrt(variances.head<3>().maxCoeff()), std::sqrt(variances.tail<3>().maxCoeff())};
  }
  const Eigen::Matrix3d covariance = planar_covariance(relation);
  return {std::sqrt(std::max(covariance(0, 0), covariance(1, 1))), std::sqrt(covariance(2, 2))};
}

}  // namespace weft
