#include "agents/methods/topometric/level_relation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace weft::agents {
namespace {

constexpr double kLeastSigmaM = 1e-3;
constexpr double kLeastSigmaRad = 1e-4;
constexpr double kAnywhereM = 50.0;
constexpr double kAnyHeadingRad = 10.0;

/// Returns the covariance of a relation of level places, of which that of x, y and heading is given.
Matrix6d in_level_space(const RelateConfig& config, const TopometricContent& a, const TopometricContent& b,
                        const Eigen::Matrix3d& planar) {
  const auto sigma_m = [&](const TopometricContent& one) {
    return one.floor.points > 0 ? config.level_sigma_m : config.unseen_sigma_m;
  };
  const auto sigma_rad = [&](const TopometricContent& one) {
    return one.floor.points > 0 ? config.level_sigma_rad : config.unseen_sigma_rad;
  };
  const double up_m = std::hypot(sigma_m(a), sigma_m(b));
  const double tilt_rad = std::hypot(sigma_rad(a), sigma_rad(b));
  constexpr Eigen::Index in_plane[] = {0, 1, 5};
  Matrix6d covariance = Matrix6d::Zero();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) covariance(in_plane[row], in_plane[column]) = planar(row, column);
  covariance(2, 2) = up_m * up_m;
  covariance(3, 3) = covariance(4, 4) = tilt_rad * tilt_rad;
  return covariance;
}

}  // namespace

Metric3 level_prior(const RelateConfig& config, const TopometricContent& a, const TopometricContent& b,
                    const Relation& a_from_b) {
  Eigen::Matrix3d covariance = planar_covariance(a_from_b);
  covariance.diagonal() +=
      Eigen::Vector3d(kLeastSigmaM * kLeastSigmaM, kLeastSigmaM * kLeastSigmaM, kLeastSigmaRad * kLeastSigmaRad);
  return {lift(planar(a_from_b)), in_level_space(config, a, b, covariance)};
}

Metric3 level_prior_about(const RelateConfig& config, const TopometricContent& a, const TopometricContent& b,
                          const Pose3& about) {
  const Eigen::Vector3d anywhere(kAnywhereM * kAnywhereM, kAnywhereM * kAnywhereM, kAnyHeadingRad * kAnyHeadingRad);
  return level_prior(config, a, b, Metric2{project(about), anywhere.asDiagonal()});
}

double sigmas_from(const RelateConfig& config, const Metric3& known, const Pose3& a_from_b) {
  Eigen::Vector3d off = se2_log(project(known.a_from_b).inverse() * project(a_from_b));
  const double away_m = off.head<2>().norm();
  off.head<2>() *= std::max(0.0, away_m - config.gate_m) / std::max(away_m, 1e-9);
  off.z() = std::copysign(std::max(0.0, std::abs(off.z()) - config.gate_rad), off.z());
  const Eigen::Matrix3d covariance = planar_covariance(known);
  return std::sqrt(off.dot(covariance.ldlt().solve(off)));
}

}  // namespace weft::agents
