#include "agents/control/spline.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace weft::agents {

namespace {

constexpr double least_spacing_m = 0.001;

Eigen::Vector2d direction(double heading) {
  return {std::cos(heading), std::sin(heading)};
}

/// Computes one cubic between two poses; the tangents at its ends are as long as the chord.
struct Piece {
  Eigen::Vector2d p0, p1, m0, m1;

  Piece(const Pose2& a, const Pose2& b) : p0(a.translation()), p1(b.translation()) {
    const double chord = (p1 - p0).norm();
    m0 = chord * direction(a.heading);
    m1 = chord * direction(b.heading);
  }
  Eigen::Vector2d point(double u) const {
    const double u2 = u * u;
    const double u3 = u2 * u;
    return (2 * u3 - 3 * u2 + 1) * p0 + (u3 - 2 * u2 + u) * m0 + (3 * u2 - 2 * u3) * p1 + (u3 - u2) * m1;
  }
  Eigen::Vector2d velocity(double u) const {
    const double u2 = u * u;
    return (6 * u2 - 6 * u) * (p0 - p1) + (3 * u2 - 4 * u + 1) * m0 + (3 * u2 - 2 * u) * m1;
  }
  Eigen::Vector2d acceleration(double u) const {
    return (12 * u - 6) * (p0 - p1) + (6 * u - 4) * m0 + (6 * u - 2) * m1;
  }
};

}  // namespace

Result<Spline> Spline::through(const std::vector<Pose2>& poses) {
  if (poses.empty()) return fail(ErrorCode::invalid, "spline: no pose given; at least one is needed");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!is_finite(poses[i])) {
      return fail(ErrorCode::invalid, "spline: pose " + std::to_string(i) + " is not finite");
    }
    if (i > 0 && (poses[i].translation() - poses[i - 1].translation()).norm() < least_spacing_m) {
      return fail(ErrorCode::invalid, "spline: poses " + std::to_string(i - 1) + " and " + std::to_string(i) +
                                          " are closer than 0.001 m; leave one of them out");
    }
  }
  Spline spline;
  spline.poses_ = poses;
  spline.samples_.reserve((poses.size() - 1) * samples_a_piece + 1);
  spline.samples_.push_back({0.0, poses.front().translation()});
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const Piece piece(poses[i], poses[i + 1]);
    for (std::size_t k = 1; k <= samples_a_piece; ++k) {
      const Eigen::Vector2d point = piece.point(static_cast<double>(k) / samples_a_piece);
      const Sample& last = spline.samples_.back();
      spline.samples_.push_back({last.along_m + (point - last.point).norm(), point});
    }
  }
  return spline;
}

PathPoint Spline::evaluate(std::size_t i, double u) const {
  const Piece piece(poses_[i], poses_[i + 1]);
  const Eigen::Vector2d point = piece.point(u);
  const Eigen::Vector2d velocity = piece.velocity(u);
  const Eigen::Vector2d acceleration = piece.acceleration(u);
  const double speed = std::max(velocity.norm(), 1e-6);
  const double cross = velocity.x() * acceleration.y() - velocity.y() * acceleration.x();
  return {{point.x(), point.y(), std::atan2(velocity.y(), velocity.x())}, cross / (speed * speed * speed)};
}

PathPoint Spline::at(double along_m) const {
  if (along_m <= 0.0 || poses_.size() == 1) {
    return {poses_.front() * Pose2{along_m, 0.0, 0.0}, 0.0};
  }
  if (along_m >= length_m()) {
    return {poses_.back() * Pose2{along_m - length_m(), 0.0, 0.0}, 0.0};
  }
  const auto after = std::upper_bound(samples_.begin(), samples_.end(), along_m,
                                      [](double along, const Sample& sample) { return along < sample.along_m; });
  const auto k = static_cast<std::size_t>(after - samples_.begin()) - 1;
  const double span = samples_[k + 1].along_m - samples_[k].along_m;
  const double share = span > 0.0 ? (along_m - samples_[k].along_m) / span : 0.0;
  const double u = (static_cast<double>(k % samples_a_piece) + share) / samples_a_piece;
  return evaluate(k / samples_a_piece, u);
}

double Spline::nearest(const Eigen::Vector2d& point, double from_m, double to_m) const {
  double best = std::clamp(0.0, from_m, to_m);
  double best_distance = (at(best).pose.translation() - point).norm();
  const auto consider = [&](double along, const Eigen::Vector2d& there) {
    const double distance = (there - point).norm();
    if (distance < best_distance) {
      best = along;
      best_distance = distance;
    }
  };
  for (std::size_t k = 0; k + 1 < samples_.size(); ++k) {
    const Sample& a = samples_[k];
    const Sample& b = samples_[k + 1];
    if (b.along_m < from_m || a.along_m > to_m || b.along_m <= a.along_m) continue;
    const Eigen::Vector2d chord = b.point - a.point;
    const double share = std::clamp((point - a.point).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    const double along = std::clamp(a.along_m + share * (b.along_m - a.along_m), from_m, to_m);
    consider(along, a.point + (along - a.along_m) / (b.along_m - a.along_m) * chord);
  }
  const double before = (poses_.front().inverse() * point).x();
  if (before < 0.0 && before >= from_m) consider(before, at(before).pose.translation());
  const double beyond = length_m() + (poses_.back().inverse() * point).x();
  if (beyond > length_m() && beyond <= to_m) consider(beyond, at(beyond).pose.translation());
  return best;
}

}  // namespace weft::agents
