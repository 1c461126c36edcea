#pragma once
#include <memory>
#include <variant>

#include "core/geometry/pose2.hpp"
#include "core/geometry/pose3.hpp"
#include "core/result.hpp"

namespace weft {

/// Relates two places metrically in the plane. Covariance of xi in a_from_b * se2_exp(xi), order (x, y, heading), m
/// and rad.
struct Metric2 {
  Pose2 a_from_b;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Keeps a covariance of six dimensions apart, shared by copies: a relation of the plane, of which a map has
/// millions, would be three times as large with room for it. Zero when nothing is said.
class Covariance6 {
 public:
  Covariance6() = default;
  template <class Derived>
  Covariance6(const Eigen::MatrixBase<Derived>& matrix) : matrix_(std::make_shared<const Matrix6d>(matrix)) {}

  const Matrix6d& matrix() const;
  operator const Matrix6d&() const { return matrix(); }

 private:
  std::shared_ptr<const Matrix6d> matrix_;
};

/// Relates two places metrically in space. Covariance of xi in a_from_b * se3_exp(xi), order (translation, rotation).
struct Metric3 {
  Pose3 a_from_b;
  Covariance6 covariance;
};

/// Relates two places along a path, for methods that know no pose: b lies `distance_m` further along the path than a
/// (negative: before it), and b's heading is turned by `heading_shift_rad` (left positive) against a's.
struct AlongPath {
  double distance_m = 0.0;
  double distance_variance_m2 = 0.0;
  double heading_shift_rad = 0.0;
  double heading_variance_rad2 = 0.0;
};

/// Relates two places by a directed, invertible operator, `a_from_b` (Gadd & Newman, III-A).
using Relation = std::variant<Metric2, Metric3, AlongPath>;

/// Returns a_from_c. Kinds mix downwards: Metric2 with Metric3 is Metric3, anything with AlongPath is AlongPath.
Relation compose(const Relation& a_from_b, const Relation& b_from_c);
Relation inverse(const Relation& a_from_b);
/// Returns how far two places are apart, >= 0, equal for a relation and its inverse: metres, with one radian counted
/// as `lever_m` metres.
double norm(const Relation& relation, double lever_m = 0.5);
double distance_m(const Relation& relation);   ///< straight line, or |along the path|
double heading_rad(const Relation& relation);  ///< b's heading seen from a, (-pi, pi]
/// Returns the planar reading of a relation; AlongPath is laid out straight ahead. For drawing and steering.
Pose2 planar(const Relation& relation);
/// Returns the covariance of the planar reading in the same convention as Metric2.
Eigen::Matrix3d planar_covariance(const Relation& relation);
/// Returns whether both are of the same kind and bit for bit the same numbers: their canonical bytes are equal.
bool identical(const Relation& first, const Relation& second);
/// Checks a relation. invalid: a number is not finite, a quaternion is not unit, a covariance is not symmetric
/// positive semi-definite.
Result<void> check(const Relation& relation);

}  // namespace weft
