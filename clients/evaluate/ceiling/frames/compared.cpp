#include "clients/evaluate/ceiling/frames/compared.hpp"

#include <cmath>

namespace weft::evaluate::ceiling {
namespace {

Eigen::Vector2d centre_of(const std::vector<Pose2>& poses) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Pose2& pose : poses) sum += pose.translation();
  return sum / static_cast<double>(poses.size());
}

Alignment align(const std::vector<Pose2>& in_a, const std::vector<Pose2>& in_b, bool fits_scale) {
  const Eigen::Vector2d middle_a = centre_of(in_a);
  const Eigen::Vector2d middle_b = centre_of(in_b);
  double along = 0.0;
  double across = 0.0;
  double squares_b = 0.0;
  for (std::size_t i = 0; i < in_a.size(); ++i) {
    const Eigen::Vector2d a = in_a[i].translation() - middle_a;
    const Eigen::Vector2d b = in_b[i].translation() - middle_b;
    along += b.dot(a);
    across += b.x() * a.y() - b.y() * a.x();
    squares_b += b.squaredNorm();
  }
  Alignment alignment;
  alignment.a_from_b.heading = std::atan2(across, along);
  if (fits_scale && squares_b > 0.0) alignment.scale = std::hypot(along, across) / squares_b;
  const Pose2 turned{0.0, 0.0, alignment.a_from_b.heading};
  const Eigen::Vector2d moved = middle_a - alignment.scale * (turned * middle_b);
  alignment.a_from_b.x = moved.x();
  alignment.a_from_b.y = moved.y();
  double squares = 0.0;
  for (std::size_t i = 0; i < in_a.size(); ++i) {
    const Eigen::Vector2d scaled = alignment.scale * in_b[i].translation();
    squares += (alignment.a_from_b * scaled - in_a[i].translation()).squaredNorm();
  }
  alignment.rms_m = std::sqrt(squares / static_cast<double>(in_a.size()));
  return alignment;
}

}  // namespace

Alignment aligned(const std::vector<Pose2>& in_a, const std::vector<Pose2>& in_b) {
  return align(in_a, in_b, false);
}

Alignment aligned_with_scale(const std::vector<Pose2>& in_a, const std::vector<Pose2>& in_b) {
  return align(in_a, in_b, true);
}

std::vector<Pose2> laid_in_a(const std::vector<Pose2>& in_a, const std::vector<Pose2>& in_b) {
  const Pose2 a_from_b = aligned(in_a, in_b).a_from_b;
  std::vector<Pose2> laid;
  Eigen::Vector2d turned = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < in_b.size(); ++i) {
    laid.push_back(a_from_b * in_b[i]);
    const double off = in_a[i].heading - laid.back().heading;
    turned += Eigen::Vector2d(std::cos(off), std::sin(off));
  }
  const double mean = std::atan2(turned.y(), turned.x());
  for (Pose2& pose : laid) pose.heading = wrap_angle(pose.heading + mean);
  return laid;
}

double heading_rms_rad(const std::vector<Pose2>& one, const std::vector<Pose2>& other) {
  double squares = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double off = wrap_angle(one[i].heading - other[i].heading);
    squares += off * off;
  }
  return std::sqrt(squares / static_cast<double>(one.size()));
}

bool is_off(const Pose2& said, const Pose2& truth, double metres, double radians) {
  const Pose2 off = truth.inverse() * said;
  return off.translation().norm() > metres || std::abs(wrap_angle(off.heading)) > radians;
}

}  // namespace weft::evaluate::ceiling
