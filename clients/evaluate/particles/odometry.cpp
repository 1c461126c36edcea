#include "clients/evaluate/particles/odometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft::evaluate::particles {
namespace {

/// Returns how much a turn is, taken forwards or backwards, whichever is less: who drives backwards turns little.
double least_turn(double radians) {
  return std::min(std::abs(wrap_angle(radians)), std::abs(wrap_angle(radians - std::numbers::pi)));
}

}  // namespace

std::vector<Pose2> simulated_odometry(const std::vector<LaserScan>& scans, const OdometryErrors& errors,
                                      std::uint64_t seed) {
  Random random(seed);
  const double bias = random.chance(0.5) ? errors.scale_bias : -errors.scale_bias;
  std::vector<Pose2> steps(scans.size());
  for (std::size_t i = 1; i < scans.size(); ++i) {
    const Pose2 step = scans[i - 1].map_from_laser.inverse() * scans[i].map_from_laser;
    const double way_m = step.translation().norm();
    const double longer = 1.0 + bias + random.normal(0.0, errors.noise);
    const double turned = step.heading * (1.0 + bias + random.normal(0.0, errors.noise)) +
                          random.normal(0.0, errors.heading_rad_m05 * std::sqrt(way_m));
    steps[i] = {step.x * longer, step.y * longer, wrap_angle(turned)};
  }
  return steps;
}

agents::UncertainMotion motion_of(const Pose2& previous_from_current, double alpha) {
  constexpr double standing_m = 0.01;  // less has no direction
  const double way_m = previous_from_current.translation().norm();
  const double first = way_m < standing_m ? 0.0 : std::atan2(previous_from_current.y, previous_from_current.x);
  const double second = wrap_angle(previous_from_current.heading - first);
  const double first_variance = alpha * (std::pow(least_turn(first), 2) + way_m * way_m);
  const double second_variance = alpha * (std::pow(least_turn(second), 2) + way_m * way_m);
  const double way_variance =
      alpha * (way_m * way_m + std::pow(least_turn(first), 2) + std::pow(least_turn(second), 2));
  // Errors of the first turn, the way and the second turn, in the frame of the step's end.
  Eigen::Matrix3d by_error = Eigen::Matrix3d::Zero();
  by_error.col(0) << way_m * std::sin(second), way_m * std::cos(second), 1.0;
  by_error.col(1) << std::cos(second), -std::sin(second), 0.0;
  by_error.col(2) << 0.0, 0.0, 1.0;
  const Eigen::Vector3d variances(first_variance, way_variance, second_variance);
  return {previous_from_current, by_error * variances.asDiagonal() * by_error.transpose()};
}

}  // namespace weft::evaluate::particles
