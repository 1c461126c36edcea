#include "agents/perception/overlap.hpp"
#include "agents/perception/plane/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {
namespace {

Polygon in_image(const Polygon& on_plane, const Eigen::Matrix3d& camera_from_plane) {
  Polygon image;
  for (const Eigen::Vector2d& p : on_plane) image.push_back(apply(camera_from_plane, p));
  return image;
}

}  // namespace

double area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& p = polygon[i];
    const Eigen::Vector2d& q = polygon[(i + 1) % polygon.size()];
    twice += p.x() * q.y() - q.x() * p.y();
  }
  return 0.5 * twice;
}

Polygon counter_clockwise(Polygon polygon) {
  if (area(polygon) < 0.0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

Polygon clip_half_plane(const Polygon& polygon, const Eigen::Vector2d& normal, double offset) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& p = polygon[i];
    const Eigen::Vector2d& q = polygon[(i + 1) % polygon.size()];
    const double at_p = normal.dot(p) + offset;
    const double at_q = normal.dot(q) + offset;
    if (at_p >= 0.0) kept.push_back(p);
    if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0))
      kept.emplace_back(p + (q - p) * at_p / (at_p - at_q));
  }
  return kept;
}

Polygon intersection(const Polygon& a, const Polygon& b) {
  Polygon left = a;
  for (std::size_t i = 0; i < b.size() && !left.empty(); ++i) {
    const Eigen::Vector2d edge = b[(i + 1) % b.size()] - b[i];
    const Eigen::Vector2d inwards(-edge.y(), edge.x());
    left = clip_half_plane(left, inwards, -inwards.dot(b[i]));
  }
  return left;
}

double share_of_b_seen_in_a(const SeenPlane& a, const SeenPlane& b, const Pose2& a_from_b) {
  const Pose2 b_from_a = a_from_b.inverse();
  Polygon a_in_b;
  for (const Eigen::Vector2d& p : a.footprint) a_in_b.push_back(b_from_a * p);
  const double whole = std::abs(area(in_image(b.footprint, b.camera_from_plane)));
  if (!(whole > 0.0)) return 0.0;
  return std::abs(area(in_image(intersection(b.footprint, a_in_b), b.camera_from_plane))) / whole;
}

}  // namespace weft::agents
