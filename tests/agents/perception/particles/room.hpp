#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "agents/perception/particles/likelihood_field.hpp"
#include "core/random.hpp"

namespace weft::agents {

/// Makes up a room without symmetries, 8 by 6 m: four walls, a cupboard, a pillar; known are the room and its walls.
class Room {
 public:
  static constexpr double kWideM = 8.0;
  static constexpr double kDeepM = 6.0;

  Room() : raster_{-1.0, -1.0, 0.05, 200, 160} {
    metres_.resize(raster_.size());
    for (int row = 0; row < raster_.rows; ++row) {
      for (int column = 0; column < raster_.columns; ++column) {
        const Eigen::Vector2d at = raster_.centre({column, row});
        metres_[raster_.index({column, row})] = is_known(at) ? static_cast<float>(distance_m(at)) : -1.0F;
      }
    }
  }

  LikelihoodField field(const LikelihoodConfig& config = {}) const { return {config, raster_, metres_}; }
  const Raster& raster() const { return raster_; }
  const std::vector<float>& metres() const { return metres_; }

  /// Returns what a laser of 240 degrees sees from a pose, with noise.
  Scan scan_from(const Pose2& room_from_robot, Random& random) const {
    Scan scan;
    for (double bearing = -2.0944; bearing <= 2.0944; bearing += 0.0174533)
      scan.beams.push_back(
          {bearing, range_m(room_from_robot, bearing) + random.normal(0.0, 0.02), 0.02, 0.0, Beam::Return::obstacle});
    return scan;
  }
  /// Draws a pose within the walls.
  static Pose2 anywhere(Random& random) {
    return {random.uniform(0.0, kWideM), random.uniform(0.0, kDeepM), random.uniform(-3.14159, 3.14159)};
  }

 private:
  static bool is_known(const Eigen::Vector2d& at) {
    return at.x() > -0.1 && at.x() < kWideM + 0.1 && at.y() > -0.1 && at.y() < kDeepM + 0.1;
  }
  static double to_box(const Eigen::Vector2d& at, double x0, double y0, double x1, double y1) {
    const double x = std::max({x0 - at.x(), at.x() - x1, 0.0});
    const double y = std::max({y0 - at.y(), at.y() - y1, 0.0});
    const double inside = std::min({at.x() - x0, x1 - at.x(), at.y() - y0, y1 - at.y()});
    return inside > 0.0 ? inside : std::hypot(x, y);
  }
  /// Returns the distance to the nearest surface.
  static double distance_m(const Eigen::Vector2d& at) {
    const double wall =
        std::min({std::abs(at.x()), std::abs(kWideM - at.x()), std::abs(at.y()), std::abs(kDeepM - at.y())});
    const double pillar = std::abs((at - Eigen::Vector2d(5.5, 2.0)).norm() - 0.3);
    return std::min({wall, pillar, to_box(at, 0.0, 4.0, 1.8, 6.0)});
  }
  /// Walks a ray from surface to surface.
  static double range_m(const Pose2& pose, double bearing) {
    const Eigen::Vector2d ahead(std::cos(pose.heading + bearing), std::sin(pose.heading + bearing));
    double range = 0.0;
    for (int i = 0; i < 400; ++i) {
      const double left = distance_m(pose.translation() + range * ahead);
      if (left < 0.002) break;
      range += left;
    }
    return range;
  }

  Raster raster_;
  std::vector<float> metres_;
};

}  // namespace weft::agents
