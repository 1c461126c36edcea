#include "agents/methods/advance.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

namespace weft::agents {
namespace {

/// `planar` (x, y, heading) is added to what the relation says of these three.
void add_planar(Relation& relation, const Eigen::Matrix3d& planar) {
  if (auto* const flat = std::get_if<Metric2>(&relation)) {
    flat->covariance += planar;
  } else if (auto* const metric = std::get_if<Metric3>(&relation)) {
    constexpr std::array<Eigen::Index, 3> kIn6 = {0, 1, 5};
    Matrix6d covariance = metric->covariance;
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < 3; ++j)
        covariance(kIn6[static_cast<std::size_t>(i)], kIn6[static_cast<std::size_t>(j)]) += planar(i, j);
    metric->covariance = covariance;
  } else {
    auto& along = std::get<AlongPath>(relation);
    along.distance_variance_m2 = std::max(0.0, along.distance_variance_m2 + planar(0, 0));
    along.heading_variance_rad2 = std::max(0.0, along.heading_variance_rad2 + planar(2, 2));
  }
}

}  // namespace

Relation advanced(const Relation& a_from_robot, const Step& step, CommonErrors& common) {
  Relation moved = compose(a_from_robot, step.previous_from_current);
  const CommonErrors carried = adjoint(planar(step.previous_from_current).inverse()) * common;
  const Eigen::Matrix3d alike = carried * step.common.transpose();  // composition took them for independent
  if (!alike.isZero(0.0)) add_planar(moved, alike + alike.transpose());
  common = carried + step.common;
  return moved;
}

CommonErrors corrected(const CommonErrors& common, const Relation& before, const Relation& after) {
  constexpr double kLeastVariance = 1e-12;
  const Eigen::Matrix3d known = planar_covariance(before) + kLeastVariance * Eigen::Matrix3d::Identity();
  return planar_covariance(after) * known.ldlt().solve(common);
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
