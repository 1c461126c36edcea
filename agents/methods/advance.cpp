#include "agents/methods/advance.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace weft::agents {
namespace {

/// Adds `alike`, a covariance of (x, y, heading), to that of a relation that is no Metric3.
void add_planar(Relation& relation, const Eigen::Matrix3d& alike) {
  if (auto* const flat = std::get_if<Metric2>(&relation)) {
    flat->covariance += alike;
  } else {
    auto& along = std::get<AlongPath>(relation);
    along.distance_variance_m2 = std::max(0.0, along.distance_variance_m2 + alike(0, 0));
    along.heading_variance_rad2 = std::max(0.0, along.heading_variance_rad2 + alike(2, 2));
  }
}

Pose3 pose_of(const Relation& relation) {
  const auto* const metric = std::get_if<Metric3>(&relation);
  return metric != nullptr ? metric->a_from_b : lift(planar(relation));
}

}  // namespace

CommonErrors in_space(const PlanarErrors& errors) {
  CommonErrors lifted = CommonErrors::Zero();
  lifted.topRows<2>() = errors.topRows<2>();
  lifted.row(kYaw) = errors.row(2);
  return lifted;
}

PlanarErrors in_plane(const CommonErrors& errors) {
  PlanarErrors flat;
  flat << errors.topRows<2>(), errors.row(kYaw);
  return flat;
}

Relation advanced(const Relation& a_from_robot, const Step& step, CommonErrors& common) {
  Relation moved = compose(a_from_robot, step.previous_from_current);
  if (auto* const metric = std::get_if<Metric3>(&moved)) {
    const CommonErrors carried = adjoint(pose_of(step.previous_from_current).inverse()) * common;
    const Matrix6d alike = carried * step.common.transpose();
    if (!alike.isZero(0.0)) metric->covariance = metric->covariance.matrix() + alike + alike.transpose();
    common = carried + step.common;
    return moved;
  }
  const PlanarErrors of_step = in_plane(step.common);
  const PlanarErrors carried = adjoint(planar(step.previous_from_current).inverse()) * in_plane(common);
  const Eigen::Matrix3d alike = carried * of_step.transpose();  // composition took them for independent
  if (!alike.isZero(0.0)) add_planar(moved, alike + alike.transpose());
  common = in_space(PlanarErrors(carried + of_step));
  return moved;
}

CommonErrors corrected(const CommonErrors& common, const Relation& before, const Relation& after) {
  constexpr double kLeastVariance = 1e-12;
  const auto* const before3 = std::get_if<Metric3>(&before);
  const auto* const after3 = std::get_if<Metric3>(&after);
  if (before3 != nullptr && after3 != nullptr) {
    const Matrix6d known = before3->covariance.matrix() + kLeastVariance * Matrix6d::Identity();
    return after3->covariance.matrix() * known.ldlt().solve(common);
  }
  const Eigen::Matrix3d known = planar_covariance(before) + kLeastVariance * Eigen::Matrix3d::Identity();
  return in_space(PlanarErrors(planar_covariance(after) * known.ldlt().solve(in_plane(common))));
}

Step joined(const Step& first, const Step& second) {
  Step both = second;
  both.common = first.common;
  both.previous_from_current = advanced(first.previous_from_current, second, both.common);
  both.seen = first.seen && second.seen;
  if (second.seen) both.blind_reason = first.blind_reason;
  return both;
}

Motion joined(const Motion& first, const Motion& second) {
  if (first.elapsed <= Duration::zero()) return second;
  Motion both;
  both.elapsed = first.elapsed + second.elapsed;
  const double share = seconds(second.elapsed) / seconds(both.elapsed);
  const auto mean = [share](double a, double b) { return a + share * (b - a); };
  both.command = {mean(first.command.linear_m_s, second.command.linear_m_s),
                  mean(first.command.angular_rad_s, second.command.angular_rad_s)};
  if (first.wheels && second.wheels) {
    both.wheels = WheelStep{first.wheels->distance_m + second.wheels->distance_m,
                            first.wheels->heading_rad + second.wheels->heading_rad};
  }
  return both;
}

}  // namespace weft::agents
