#include "tests/simulation/ring_site.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft::simulation {
namespace {

constexpr double kLong = 27.0;   // straight part of the long sides
constexpr double kShort = 9.0;   // of the short sides
constexpr double kRadius = 1.5;  // of the corners
constexpr double kQuarter = kRadius * std::numbers::pi / 2.0;
constexpr double kSidingHalf = 4.0;  // a siding leaves the ring this far before its station
constexpr double kSidingRamp = 2.5;  // and takes this long to be beside it
constexpr double kSidingOffset = 1.8;
constexpr double kOrigin = 6.0;  // the marks reach this far beyond the ring
constexpr double kCell = 1.0;
constexpr int kColumns = 46;
constexpr int kRows = 28;

/// Point and heading on one side of the ring and the corner that follows it.
Pose2 along_side(double at_m, double straight_m) {
  if (at_m <= straight_m) return {at_m, 0.0, 0.0};
  const double angle = (at_m - straight_m) / kRadius;
  return {straight_m + kRadius * std::sin(angle), kRadius * (1.0 - std::cos(angle)), angle};
}

int cell_of(double x, double y) {
  const int column = std::clamp(static_cast<int>(std::floor((x + kOrigin) / kCell)), 0, kColumns - 1);
  const int row = std::clamp(static_cast<int>(std::floor((y + kOrigin) / kCell)), 0, kRows - 1);
  return row * kColumns + column;
}

}  // namespace

RingSite::RingSite(Random random) : length_m_(2.0 * (kLong + kShort) + 4.0 * kQuarter), cells_(kColumns * kRows) {
  const double second = kLong + kQuarter;
  const double third = second + kShort + kQuarter;
  const double fourth = third + kLong + kQuarter;
  stations_ = {4.5, 13.5, 22.5, second + 4.5, third + 4.5, third + 13.5, third + 22.5, fourth + 4.5};
  std::uint64_t number = 1;
  for (double y = -kOrigin; y < kRows * kCell - kOrigin; y += 0.6) {
    for (double x = -kOrigin; x < kColumns * kCell - kOrigin; x += 0.6) {
      const Pose2 pose{x + random.uniform(-0.2, 0.2), y + random.uniform(-0.2, 0.2), random.uniform(-3.0, 3.0)};
      const std::uint64_t shown = random.chance(0.02) ? 1 + random.below(number) : number;
      cells_[static_cast<std::size_t>(cell_of(pose.x, pose.y))].push_back({shown, pose});
      ++number;
    }
  }
}

Pose2 RingSite::on_ring(double along_m) const {
  double rest = std::fmod(along_m, length_m_);
  if (rest < 0.0) rest += length_m_;
  Pose2 start;
  for (const double straight : {kLong, kShort, kLong, kShort}) {
    if (rest <= straight + kQuarter) return start * along_side(rest, straight);
    rest -= straight + kQuarter;
    start = start * along_side(straight + kQuarter, straight);
  }
  return start;
}

double RingSite::offset_m(double along_m, const std::vector<std::size_t>& through) const {
  double offset = 0.0;
  for (const std::size_t station : through) {
    const double away = std::abs(std::remainder(along_m - stations_[station], length_m_));
    if (away >= kSidingHalf) continue;
    const double share = std::min(1.0, (kSidingHalf - away) / kSidingRamp);
    offset = std::max(offset, kSidingOffset * 0.5 * (1.0 - std::cos(std::numbers::pi * share)));
  }
  return offset;
}

Pose2 RingSite::pose(double along_m, const std::vector<std::size_t>& through) const {
  const auto point = [&](double at_m) { return on_ring(at_m) * Eigen::Vector2d(0.0, -offset_m(at_m, through)); };
  const Eigen::Vector2d here = point(along_m);
  const Eigen::Vector2d ahead = point(along_m + 0.01) - point(along_m - 0.01);
  return {here.x(), here.y(), std::atan2(ahead.y(), ahead.x())};
}

std::vector<agents::SitePoint> RingSite::line(double from_m, double to_m,
                                              const std::vector<std::size_t>& through) const {
  std::vector<agents::SitePoint> points;
  const auto count = static_cast<std::size_t>(std::ceil((to_m - from_m) / 0.25));
  for (std::size_t i = 0; i <= count; ++i) {
    const Pose2 at = pose(from_m + (to_m - from_m) * static_cast<double>(i) / static_cast<double>(count), through);
    points.push_back({at.x, at.y});
  }
  return points;
}

std::vector<agents::Marks::Sighting> RingSite::seen_from(const Pose2& site_from_robot) const {
  std::vector<agents::Marks::Sighting> seen;
  const Pose2 robot_from_site = site_from_robot.inverse();
  const Eigen::Vector2d middle = site_from_robot * Eigen::Vector2d(1.0, 0.0);
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const int column = static_cast<int>(std::floor((middle.x() + kOrigin) / kCell)) + dx;
      const int row = static_cast<int>(std::floor((middle.y() + kOrigin) / kCell)) + dy;
      if (column < 0 || column >= kColumns || row < 0 || row >= kRows) continue;
      for (const Mark& mark : cells_[static_cast<std::size_t>(row * kColumns + column)]) {
        const Pose2 robot_from_mark = robot_from_site * mark.site_from_mark;
        if (robot_from_mark.x > 0.2 && robot_from_mark.x < 1.8 && std::abs(robot_from_mark.y) < 0.9) {
          seen.push_back({mark.number, robot_from_mark});
        }
      }
    }
  }
  return seen;
}

}  // namespace weft::simulation
