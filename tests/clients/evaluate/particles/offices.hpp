#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "clients/evaluate/particles/carmen_log.hpp"
#include "core/random.hpp"

namespace weft::evaluate::particles {

/// Makes up a floor of offices, 26 by 20 m: a corridor of 2 m all round, rooms on either side of it, each with a door
/// and with furniture of its own. A robot is driven round, into each room and out again.
class Offices {
 public:
  explicit Offices(std::uint64_t seed) : random_(seed) {
    add_box({0.0, 0.0}, {26.0, 20.0});
    add_row({0.0, 0.0}, 26.0, 6, 5.0, 6.0);
    add_row({0.0, 15.0}, 26.0, 6, 15.0, 14.0);
    add_row({7.0, 7.0}, 12.0, 3, 7.0, 6.0);
    walls_.push_back({{7.0, 12.0}, {19.0, 12.0}});
    for (const double x : {5.0, 21.0}) walls_.push_back({{x, 5.0}, {x, 15.0}});
    walls_.push_back({{0.0, 10.0}, {5.0, 10.0}});
    walls_.push_back({{21.0, 10.0}, {26.0, 10.0}});
    std::sort(visits_.begin(), visits_.end(), [](const Visit& a, const Visit& b) { return a.along_m < b.along_m; });
  }

  /// Returns the log of a laser that is driven round once: a scan each 0.55 m and each 0.8 rad.
  std::vector<LaserScan> driven() {
    std::vector<LaserScan> scans;
    Pose2 at{6.0, 6.0, 0.0};
    for (const Eigen::Vector2d& to : way()) drive(scans, at, to);
    return scans;
  }

 private:
  struct Wall {
    Eigen::Vector2d from, to;
  };
  struct Visit {
    double along_m;  ///< of the corridor, from (6, 6) on
    Eigen::Vector2d before, within;
  };

  void add_box(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    const Eigen::Vector2d right(high.x(), low.y());
    const Eigen::Vector2d left(low.x(), high.y());
    for (const Wall& wall : {Wall{low, right}, Wall{right, high}, Wall{high, left}, Wall{left, low}})
      walls_.push_back(wall);
  }
  /// Adds rooms beside each other, 5 m deep, whose doors are in the wall at `door_y`, off a corridor along `way_y`.
  void add_row(const Eigen::Vector2d& corner, double length_m, int rooms, double door_y, double way_y) {
    double x = corner.x();
    for (int i = 0; i < rooms; ++i) {
      const double next = i + 1 == rooms ? corner.x() + length_m
                                         : corner.x() + length_m / rooms * (i + 1) + random_.uniform(-0.3, 0.3);
      add_room({x, corner.y()}, {next, corner.y() + 5.0}, door_y, way_y);
      x = next;
    }
  }
  void add_room(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double door_y, double way_y) {
    const double middle = 0.5 * (low.x() + high.x());
    walls_.push_back({{high.x(), low.y()}, high});
    walls_.push_back({{low.x(), low.y()}, {low.x(), high.y()}});
    walls_.push_back({{low.x(), door_y}, {middle - 0.5, door_y}});
    walls_.push_back({{middle + 0.5, door_y}, {high.x(), door_y}});
    for (int i = 0; i < 3; ++i) {  // furniture beside the way in
      const double side = random_.chance(0.5) ? 1.0 : -1.0;
      const Eigen::Vector2d centre(middle + side * random_.uniform(0.9, 1.5), low.y() + random_.uniform(0.5, 4.5));
      const Eigen::Vector2d half(random_.uniform(0.1, 0.3), random_.uniform(0.1, 0.5));
      add_box(centre - half, centre + half);
    }
    if (middle < 6.0 || middle > 20.0) return;  // its door is not off the corridor
    const double along_m = way_y < 10.0 ? middle - 6.0 : 100.0 - middle;
    visits_.push_back({along_m, {middle, way_y}, {middle, 0.5 * (low.y() + high.y())}});
  }
  std::vector<Eigen::Vector2d> way() const {
    std::vector<Eigen::Vector2d> way;
    for (const Visit& visit : visits_) {
      if (visit.along_m > 50.0 && std::none_of(way.begin(), way.end(), [](const auto& at) { return at.y() > 13.0; }))
        way.insert(way.end(), {{20.0, 6.0}, {20.0, 14.0}});
      way.insert(way.end(), {visit.before, visit.within, visit.before});
    }
    way.insert(way.end(), {{6.0, 14.0}, {6.0, 6.0}});
    return way;
  }
  void drive(std::vector<LaserScan>& scans, Pose2& at, const Eigen::Vector2d& to) {
    constexpr double most_rad = 0.8;
    constexpr double most_m = 0.55;
    const Eigen::Vector2d left = to - at.translation();
    if (left.norm() < 0.05) return;
    const double turn = wrap_angle(std::atan2(left.y(), left.x()) - at.heading);
    const int turns = static_cast<int>(std::ceil(std::abs(turn) / most_rad));
    for (int i = 0; i < turns; ++i) {
      scans.push_back(scan_from(at));
      at.heading = wrap_angle(at.heading + turn / turns);
    }
    const int steps = static_cast<int>(std::ceil(left.norm() / most_m));
    for (int i = 0; i < steps; ++i) {
      scans.push_back(scan_from(at));
      at.x += left.x() / steps;
      at.y += left.y() / steps;
    }
  }
  /// Returns what a laser sees: ranges with noise, some cut short by who walks there, at a pose as a log has it.
  LaserScan scan_from(const Pose2& at) {
    constexpr std::size_t rays = 180;
    LaserScan scan;
    scan.ranges_m.resize(rays);
    for (std::size_t i = 0; i < rays; ++i) {
      double range = range_m(at, scan.bearing_rad(i));
      if (random_.chance(0.05)) range *= random_.uniform(0.3, 1.0);
      scan.ranges_m[i] = static_cast<float>(std::max(0.02, range + random_.normal(0.0, 0.02)));
    }
    scan.map_from_laser =
        at * Pose2{random_.normal(0.0, 0.02), random_.normal(0.0, 0.02), random_.normal(0.0, 0.005)};
    return scan;
  }
  double range_m(const Pose2& at, double bearing) const {
    const Eigen::Vector2d ahead(std::cos(at.heading + bearing), std::sin(at.heading + bearing));
    double nearest = 80.0;
    for (const Wall& wall : walls_) {
      const Eigen::Vector2d along = wall.to - wall.from;
      const Eigen::Vector2d off = wall.from - at.translation();
      const double across = ahead.x() * along.y() - ahead.y() * along.x();
      if (std::abs(across) < 1e-12) continue;
      const double range = (off.x() * along.y() - off.y() * along.x()) / across;
      const double share = (off.x() * ahead.y() - off.y() * ahead.x()) / across;
      if (range > 0.0 && range < nearest && share >= 0.0 && share <= 1.0) nearest = range;
    }
    return nearest;
  }

  Random random_;
  std::vector<Wall> walls_;
  std::vector<Visit> visits_;
};

}  // namespace weft::evaluate::particles
