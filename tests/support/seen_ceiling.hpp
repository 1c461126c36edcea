#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "agents/adjustment/mosaic.hpp"
#include "core/random.hpp"

namespace weft::agents {

/// Returns poses along a straight line.
inline std::vector<Pose2> line_way(std::size_t places, double step_m) {
  std::vector<Pose2> way;
  for (std::size_t i = 0; i < places; ++i) way.push_back({static_cast<double>(i) * step_m, 0.0, 0.0});
  return way;
}

/// Returns poses once round a circle.
inline std::vector<Pose2> loop_way(std::size_t places, double step_m) {
  const double turn = 2.0 * std::numbers::pi / static_cast<double>(places);
  std::vector<Pose2> way{{}};
  while (way.size() < places) way.push_back(way.back() * se2_exp({step_m, 0.0, turn}));
  return way;
}

/// Drives a way below a ceiling at 6.4 m, a third of whose corners hang up to 1.5 m below it, with a camera that
/// leans by 2 degrees, and holds what is seen as the adjustment gets it: places as odometry has them, some percent
/// long and drifting, points all at the ceiling's height, which ones hang, and where they do within 0.8 m.
struct SeenCeiling {
  struct Drive {
    std::vector<Pose2> way;
    std::size_t stitches = 0;  ///< of places before the end with such at the beginning
    std::uint64_t seed = 1;
    double longer = 0.01;      ///< share by which odometry is too long
    double sigma_rad = 0.001;  ///< of a ray, each way
  };

  explicit SeenCeiling(Drive how) : truth(how.way), drive_(std::move(how)) {
    Random random(drive_.seed);
    const Eigen::AngleAxisd lean(0.035, Eigen::Vector3d::UnitY());
    Eigen::Matrix3d up;  // the image's right on the robot's right
    up.col(2) = Eigen::Vector3d::UnitZ();
    up.col(0) = -Eigen::Vector3d::UnitY();
    up.col(1) = up.col(2).cross(up.col(0));
    mosaic.robot_from_camera = {Eigen::Quaterniond(lean.toRotationMatrix() * up), {0.1, 0.0, 0.5}};
    hang(random);
    drive_on(random);
    for (std::size_t i = 0; i < drive_.stitches; ++i) stitch(truth.size() - 1 - 2 * i, drive_.stitches - i, random);
    sight(random);
  }

  Mosaic mosaic;
  std::vector<Pose2> truth;
  std::vector<Eigen::Vector3d> points;  ///< where they are

 private:
  Drive drive_;

  void hang(Random& random) {
    Eigen::AlignedBox2d box;
    for (const Pose2& pose : truth) box.extend(pose.translation());
    constexpr double beyond_m = 6.0;
    constexpr double each_m2 = 1.0;
    const Eigen::Vector2d size = box.sizes() + Eigen::Vector2d::Constant(2.0 * beyond_m);
    const auto count = static_cast<std::size_t>(size.prod() / each_m2);
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector2d at = box.min() - Eigen::Vector2d::Constant(beyond_m) +
                                 Eigen::Vector2d(random.uniform(0.0, size.x()), random.uniform(0.0, size.y()));
      const double below = random.uniform(0.0, 1.0) < 1.0 / 3.0 ? random.uniform(0.3, 1.5) : 0.0;
      points.emplace_back(at.x(), at.y(), 6.4 - below);
    }
  }

  void drive_on(Random& random) {
    mosaic.places.push_back({truth.front(), {}, {0.003, 0.003, 0.002}});
    for (std::uint32_t i = 1; i < truth.size(); ++i) {
      const Pose2 step = truth[i - 1].inverse() * truth[i];
      const Eigen::Vector3d noise(drive_.longer * step.x + random.normal(0.0, 0.004), random.normal(0.0, 0.004),
                                  random.normal(0.0, 0.004));
      const Pose2 odometry = step * se2_exp(noise);
      const Eigen::Vector3d variances = Eigen::Vector3d(0.006, 0.004, 0.004).cwiseAbs2();
      mosaic.links.push_back({i - 1, i, odometry, variances.asDiagonal(), false});
      mosaic.places.push_back({mosaic.places.back().map_from_place * odometry, {}, {0.003, 0.003, 0.002}});
    }
  }

  void stitch(std::size_t from, std::size_t to, Random& random) {
    const Eigen::Vector3d noise(random.normal(0.0, 0.01), random.normal(0.0, 0.01), random.normal(0.0, 0.003));
    const Eigen::Vector3d variances = Eigen::Vector3d(0.01, 0.01, 0.003).cwiseAbs2();
    mosaic.links.push_back({static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to),
                            truth[from].inverse() * truth[to] * se2_exp(noise), variances.asDiagonal(), true});
  }

  void sight(Random& random) {
    constexpr double widest = 0.8;  // tangent from the optical axis
    for (const Eigen::Vector3d& point : points)
      mosaic.points.push_back(point.z() == 6.4 ? MosaicPoint{point, 6.4, 0.02} : MosaicPoint{point, 5.5, 0.8});
    std::vector<bool> is_seen(points.size(), false);
    for (std::uint32_t place = 0; place < truth.size(); ++place) {
      const Attitude sway{random.normal(0.0, 0.002), random.normal(0.0, 0.002), random.normal(0.0, 0.001)};
      const Pose3 camera_from_map = (lift(truth[place]) * level_from_body(sway) * mosaic.robot_from_camera).inverse();
      for (std::uint32_t i = 0; i < points.size(); ++i) {
        Eigen::Vector3d ray = (camera_from_map * points[i]).normalized();
        if (ray.z() < 0.1 || ray.head<2>().norm() > widest * ray.z()) continue;
        ray += drive_.sigma_rad * Eigen::Vector3d(random.normal(0.0, 1.0), random.normal(0.0, 1.0), 0.0);
        mosaic.sightings.push_back({place, i, ray.normalized(), drive_.sigma_rad});
        if (!is_seen[i]) mosaic.points[i].in_map = *met(mosaic, mosaic.sightings.back(), 6.4);
        is_seen[i] = true;
      }
    }
  }
};

}  // namespace weft::agents
