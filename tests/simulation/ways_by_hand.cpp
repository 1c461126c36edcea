#include "tests/simulation/ways_by_hand.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace weft::simulation {
namespace {

constexpr double kRadius_m = 0.9;
constexpr double kPoint_m = 0.25;

struct Way {
  double first_rad = 0.0;  ///< left is positive
  double straight_m = 0.0;
  double last_rad = 0.0;

  double length_m() const { return kRadius_m * (std::abs(first_rad) + std::abs(last_rad)) + straight_m; }
};

/// Returns an angle in [0, 2 pi), turned in the direction of `side`.
double turned(double radians, double side) {
  const double whole = 2.0 * std::numbers::pi;
  const double rest = std::fmod(side * radians, whole);
  return side * (rest < 0.0 ? rest + whole : rest);
}

/// Returns a way; `first`, `last`: 1 for a curve to the left, -1 to the right. None: the two circles are too close.
std::optional<Way> way_by(const Pose2& from, const Pose2& to, double first, double last) {
  const Eigen::Vector2d apart =
      to * Eigen::Vector2d(0.0, last * kRadius_m) - from * Eigen::Vector2d(0.0, first * kRadius_m);
  const double distance = apart.norm();
  double heading = std::atan2(apart.y(), apart.x());
  double straight = distance;
  if (first != last) {
    if (distance < 2.0 * kRadius_m) return std::nullopt;
    heading += first * std::asin(2.0 * kRadius_m / distance);
    straight = std::sqrt(distance * distance - 4.0 * kRadius_m * kRadius_m);
  }
  return Way{turned(heading - from.heading, first), straight, turned(to.heading - heading, last)};
}

std::vector<agents::SitePoint> points_of(const Pose2& from, const Way& way) {
  std::vector<agents::SitePoint> points = {{from.x, from.y}};
  Pose2 at = from;
  const auto go = [&](double metres, double turn_rad) {
    const double count = std::ceil(metres / kPoint_m);
    for (double i = 0.0; i < count; i += 1.0) {
      at = at * se2_exp({metres / count, 0.0, turn_rad / count});
      points.push_back({at.x, at.y});
    }
  };
  go(kRadius_m * std::abs(way.first_rad), way.first_rad);
  go(way.straight_m, 0.0);
  go(kRadius_m * std::abs(way.last_rad), way.last_rad);
  return points;
}

}  // namespace

std::vector<std::vector<agents::SitePoint>> ways_by_hand(const Pose2& from, const Pose2& to) {
  std::vector<Way> ways;
  for (const auto& [first, last] : std::array<std::pair<double, double>, 4>{{{1, 1}, {-1, -1}, {1, -1}, {-1, 1}}}) {
    if (const auto way = way_by(from, to, first, last)) ways.push_back(*way);
  }
  std::stable_sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.length_m() < b.length_m(); });
  std::vector<std::vector<agents::SitePoint>> lines;
  for (const Way& way : ways) lines.push_back(points_of(from, way));
  return lines;
}

}  // namespace weft::simulation
