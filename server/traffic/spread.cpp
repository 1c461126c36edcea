#include "server/traffic/spread.hpp"

#include <algorithm>
#include <cmath>

namespace weft::server {
namespace {

/// States how far behind a place an uncertain heading is reckoned to move things.
constexpr double kHeadingLever_m = 10.0;
/// Breaks ties between chains: of two that are equally certain the shorter one is taken, and of two equally long ones
/// that of fewer edges.
constexpr double kLeastUncertainty = 1e-9;

Metric2 bent(const AlongPath& path) {
  const double half_turn = 0.5 * path.heading_shift_rad;
  const double length = path.distance_m;
  Metric2 flat;
  flat.a_from_b = se2_exp({length, 0.0, path.heading_shift_rad});
  const Eigen::Vector2d along_in_b{std::cos(half_turn), -std::sin(half_turn)};
  const Eigen::Vector2d across_in_b{-along_in_b.y(), along_in_b.x()};
  // A heading that drifts evenly to its error leads aside by a third of its variance; of a turn at the very beginning
  // or end the whole half is taken for one standard deviation.
  const double across_m2 = length * length * (path.heading_variance_rad2 / 3.0 + half_turn * half_turn);
  flat.covariance.topLeftCorner<2, 2>() = path.distance_variance_m2 * along_in_b * along_in_b.transpose() +
                                          across_m2 * across_in_b * across_in_b.transpose();
  flat.covariance(2, 2) = path.heading_variance_rad2;
  return flat;
}

}  // namespace

Spread::Spread(const Eigen::Matrix3d& covariance)
    : upper_{covariance(0, 0), covariance(0, 1), covariance(0, 2),
             covariance(1, 1), covariance(1, 2), covariance(2, 2)} {}

Eigen::Matrix3d Spread::matrix() const {
  Eigen::Matrix3d full;
  full << upper_[0], upper_[1], upper_[2],  //
      upper_[1], upper_[3], upper_[4],      //
      upper_[2], upper_[4], upper_[5];
  return full;
}

Spread Spread::since(const Spread& earlier) const {
  Spread rest;
  for (std::size_t i = 0; i < upper_.size(); ++i) rest.upper_[i] = upper_[i] - earlier.upper_[i];
  return rest;
}

Eigen::Matrix2d Spread::at(const Eigen::Vector2d& point) const {
  const auto& [xx, xy, xh, yy, yh, hh] = upper_;
  const double x = point.x();
  const double y = point.y();
  Eigen::Matrix2d covariance;
  covariance(0, 0) = std::max(0.0, xx - 2.0 * y * xh + y * y * hh);
  covariance(1, 1) = std::max(0.0, yy + 2.0 * x * yh + x * x * hh);
  covariance(0, 1) = xy + x * xh - y * yh - x * y * hh;
  covariance(1, 0) = covariance(0, 1);
  return covariance;
}

Metric2 laid_flat(const Relation& relation) {
  if (const auto* const flat = std::get_if<Metric2>(&relation)) return *flat;
  if (const auto* const path = std::get_if<AlongPath>(&relation)) return bent(*path);
  return {planar(relation), planar_covariance(relation)};
}

double uncertainty_of(const Edge& edge) {
  const Metric2 flat = laid_flat(edge.a_from_b);
  const double position_m2 = flat.covariance(0, 0) + flat.covariance(1, 1);
  const double heading_m2 = kHeadingLever_m * kHeadingLever_m * flat.covariance(2, 2);
  const double length_m2 = flat.a_from_b.translation().squaredNorm();
  return position_m2 + heading_m2 + kLeastUncertainty * (1.0 + length_m2);
}

double largest_sigma_m(const Eigen::Matrix2d& covariance) {
  const double mean = 0.5 * covariance.trace();
  const double half_difference = 0.5 * (covariance(0, 0) - covariance(1, 1));
  return std::sqrt(std::max(0.0, mean + std::hypot(half_difference, covariance(0, 1))));
}

double share_of_bend(double heading_variance_rad2) {
  return std::min(1.0, 0.5 * kLayoutSigmas * std::sqrt(std::max(0.0, heading_variance_rad2)));
}

double least_distance_m(const Eigen::Vector2d& apart, const Eigen::Matrix2d& covariance, double bend) {
  const double distance_m = apart.norm();
  if (distance_m == 0.0) return 0.0;
  const Eigen::Vector2d direction = apart / distance_m;
  const double along_m = std::sqrt(std::max(0.0, direction.dot(covariance * direction)));
  // All positions within the ellipse lie beyond the line that touches it on the near side, however small the distance
  // is beside the ellipse.
  return std::max(0.0, distance_m - kLayoutSigmas * (along_m + bend * largest_sigma_m(covariance)));
}

}  // namespace weft::server
