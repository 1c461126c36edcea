#include "core/camera/lens.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

namespace weft {
namespace {

/// Holds a value and its derivative: of `radial_at`, the factor on a ray's distance from the axis, by the squared
/// distance; of `radius_at`, the distance itself, by the ray's angle.
struct Radial {
  double value;
  double slope;
};

Radial radial_at(const Lens& lens, double r2) {
  const auto& [k1, k2, p1, p2, k3] = lens.distortion;
  const Radial above{1.0 + r2 * (k1 + r2 * (k2 + r2 * k3)), k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3)};
  if (lens.model != LensModel::rational) return above;
  const auto& [k4, k5, k6] = lens.divisor;
  const Radial below{1.0 + r2 * (k4 + r2 * (k5 + r2 * k6)), k4 + r2 * (2.0 * k5 + r2 * 3.0 * k6)};
  const double value = above.value / below.value;
  return {value, (above.slope - value * below.slope) / below.value};
}

/// Returns where a normalised point lands by Brown's model, or by the rational one.
Eigen::Vector2d distort(const Lens& lens, const Eigen::Vector2d& n) {
  const double p1 = lens.distortion[2];
  const double p2 = lens.distortion[3];
  const double r2 = n.squaredNorm();
  const double radial = radial_at(lens, r2).value;
  const double xy = n.x() * n.y();
  return {n.x() * radial + 2.0 * p1 * xy + p2 * (r2 + 2.0 * n.x() * n.x()),
          n.y() * radial + p1 * (r2 + 2.0 * n.y() * n.y()) + 2.0 * p2 * xy};
}

/// Returns the derivative of `distort`.
Eigen::Matrix2d slope_of(const Lens& lens, const Eigen::Vector2d& n) {
  const double p1 = lens.distortion[2];
  const double p2 = lens.distortion[3];
  const auto [value, slope] = radial_at(lens, n.squaredNorm());
  const double across = 2.0 * n.x() * n.y() * slope + 2.0 * p1 * n.x() + 2.0 * p2 * n.y();
  Eigen::Matrix2d derivative;
  derivative << value + 2.0 * n.x() * n.x() * slope + 2.0 * p1 * n.y() + 6.0 * p2 * n.x(), across,  //
      across, value + 2.0 * n.y() * n.y() * slope + 6.0 * p1 * n.y() + 2.0 * p2 * n.x();
  return derivative;
}

/// Takes the distortion for a shift and subtracts it again and again: the quickest for usual lenses. None: it does
/// not settle, or beyond a fold.
std::optional<Eigen::Vector2d> undistort_gently(const Lens& lens, const Eigen::Vector2d& target) {
  constexpr int kRounds = 30;
  constexpr double kGood = 1e-22;
  Eigen::Vector2d n = target;
  for (int i = 0; i < kRounds; ++i) {
    const Eigen::Vector2d error = target - distort(lens, n);
    n += error;
    if (error.squaredNorm() < kGood) return slope_of(lens, n).determinant() > 0.0 ? std::optional(n) : std::nullopt;
  }
  return std::nullopt;
}

/// Steps from the axis outwards, each shortened until it comes nearer and stays where the lens has not folded.
Eigen::Vector2d undistort(const Lens& lens, const Eigen::Vector2d& target) {
  constexpr int kSteps = 50;
  constexpr int kShortenings = 10;
  constexpr double kGood = 1e-24;
  if (const std::optional<Eigen::Vector2d> gentle = undistort_gently(lens, target)) return *gentle;
  Eigen::Vector2d n = Eigen::Vector2d::Zero();
  Eigen::Vector2d error = target;
  Eigen::Matrix2d slope = Eigen::Matrix2d::Identity();
  for (int i = 0; i < kSteps && error.squaredNorm() > kGood; ++i) {
    Eigen::Vector2d step = slope.inverse() * error;
    bool is_nearer = false;
    for (int k = 0; k < kShortenings && !is_nearer; ++k, step *= 0.5) {
      const Eigen::Vector2d trial = n + step;
      const Eigen::Vector2d trial_error = target - distort(lens, trial);
      const Eigen::Matrix2d trial_slope = slope_of(lens, trial);
      if (!(trial_error.squaredNorm() < error.squaredNorm()) || trial_slope.determinant() <= 0.0) continue;
      n = trial;
      error = trial_error;
      slope = trial_slope;
      is_nearer = true;
    }
    if (!is_nearer) break;
  }
  return n;
}

/// Returns how far from the axis a ray at this angle lands, in focal lengths, and its derivative by the angle
/// (Kannala & Brandt 2006, eq. 6 with k1 = 1).
Radial radius_at(const Lens& lens, double angle) {
  const auto& [k1, k2, k3, k4, none] = lens.distortion;
  const double a2 = angle * angle;
  return {angle * (1.0 + a2 * (k1 + a2 * (k2 + a2 * (k3 + a2 * k4)))),
          1.0 + a2 * (3.0 * k1 + a2 * (5.0 * k2 + a2 * (7.0 * k3 + a2 * 9.0 * k4)))};
}

/// Returns the least angle that lands at this radius: brackets it from the axis outwards, then takes Newton's steps
/// within the bracket. Returns `kWidestRay` where no angle up to it lands that far out.
double angle_at(const Lens& lens, double radius) {
  constexpr double kStride = kWidestRay / 24.0;
  double high = kStride;
  while (high < kWidestRay && radius_at(lens, high).value < radius) high += kStride;
  high = std::min(high, kWidestRay);
  if (radius_at(lens, high).value < radius) return kWidestRay;
  double low = std::max(high - kStride, 0.0);
  double angle = 0.5 * (low + high);
  for (int i = 0; i < 60; ++i) {
    const Radial at = radius_at(lens, angle);
    (at.value < radius ? low : high) = angle;
    double next = angle + (radius - at.value) / at.slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double step = next - angle;
    angle = next;
    if (std::abs(step) < 1e-14) break;
  }
  return angle;
}

}  // namespace

const char* to_string(LensModel lens) {
  switch (lens) {
    case LensModel::radtan:
      return "radtan";
    case LensModel::equidistant:
      return "equidistant";
    case LensModel::rational:
      return "rational";
  }
  return "unknown";
}

Eigen::Vector2d bend(const Lens& lens, const Eigen::Vector2d& normalised) {
  if (lens.model != LensModel::equidistant) return distort(lens, normalised);
  const double off_axis = normalised.norm();
  if (off_axis < 1e-12) return normalised;
  return normalised * (radius_at(lens, std::atan(off_axis)).value / off_axis);
}

Eigen::Vector2d unbend(const Lens& lens, const Eigen::Vector2d& bent) {
  if (lens.model != LensModel::equidistant) return undistort(lens, bent);
  const double radius = bent.norm();
  if (radius < 1e-12) return bent;
  return bent * (std::tan(angle_at(lens, radius)) / radius);
}

}  // namespace weft
