#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "agents/perception/view.hpp"
#include "core/geometry/pose3.hpp"
#include "tests/support/marks.hpp"

namespace weft::agents::tiny {

/// Describes a floor that rises by 0.3 m between x = 6 and 9 m, and marks that hang above it.
struct Ramp {
  static constexpr double from_x = 6.0, to_x = 9.0, rise_m = 0.3;

  static double share(double x) { return std::clamp((x - from_x) / (to_x - from_x), 0.0, 1.0); }
  static double z(double x) { return rise_m * share(x) * share(x) * (3.0 - 2.0 * share(x)); }
  static double slope(double x) { return rise_m * 6.0 * share(x) * (1.0 - share(x)) / (to_x - from_x); }
  /// Returns the pose in space of a robot whose pose on the plan is this.
  static Pose3 world_from_robot(const Pose2& plan) {
    const Eigen::Vector3d up = Eigen::Vector3d(-slope(plan.x), 0.0, 1.0).normalized();
    const Eigen::Vector3d heading(std::cos(plan.heading), std::sin(plan.heading), 0.0);
    const Eigen::Vector3d ahead = (heading - heading.dot(up) * up).normalized();
    Eigen::Matrix3d axes;
    axes << ahead, up.cross(ahead), up;
    return {Eigen::Quaterniond(axes), {plan.x, plan.y, z(plan.x)}};
  }
  static Eigen::Vector3d world_from_mark(std::uint64_t mark, const Eigen::Vector2d& plan) {
    return {plan.x(), plan.y(), z(plan.x()) + 1.2 + 0.3 * static_cast<double>(mark % 4)};
  }
};

/// Simulates two cameras that look up from the robot's origin, the right one 0.25 m further along y.
struct StereoUp {
  static constexpr int side_px = 1024;
  static constexpr double focal_px = 380.0, baseline_m = 0.25;

  /// Draws each mark as four grey values in a row: two of its number, two of where in the first one's pixel it lies.
  static Image draw(const std::vector<std::pair<std::uint64_t, Eigen::Vector3d>>& marks, double aside_m) {
    Bytes pixels(static_cast<std::size_t>(side_px) * side_px, 0);
    for (const auto& [mark, at] : marks) {
      const double down = 0.5 * side_px + focal_px * at.x() / at.z();
      const double right = 0.5 * side_px + focal_px * (at.y() - aside_m) / at.z();
      if (down < 0.0 || down >= side_px || right < 0.0 || right + 4.0 >= side_px) continue;
      const auto row = static_cast<std::size_t>(down);
      const auto column = static_cast<std::size_t>(right);
      std::uint8_t* const pixel = &pixels[row * side_px + column];
      pixel[0] = static_cast<std::uint8_t>(1 + mark / 255);
      pixel[1] = static_cast<std::uint8_t>(1 + mark % 255);
      pixel[2] = static_cast<std::uint8_t>(1.0 + 254.0 * (down - static_cast<double>(row)));
      pixel[3] = static_cast<std::uint8_t>(1.0 + 254.0 * (right - static_cast<double>(column)));
    }
    return {side_px, side_px, std::make_shared<const Bytes>(std::move(pixels))};
  }
  /// Returns what the pair shows of the marks that a robot sees on the plan.
  static StereoPair look(const Marks& seen, const Pose2& plan) {
    std::vector<std::pair<std::uint64_t, Eigen::Vector3d>> marks;
    const Pose3 robot_from_world = Ramp::world_from_robot(plan).inverse();
    for (const Marks::Sighting& one : seen.sightings) {
      const Eigen::Vector2d on_plan = plan * one.robot_from_mark.translation();
      marks.emplace_back(one.mark, robot_from_world * Ramp::world_from_mark(one.mark, on_plan));
    }
    return {draw(marks, 0.0), draw(marks, baseline_m)};
  }
};

}  // namespace weft::agents::tiny
