#include "tests/bench/topometric/made_room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace weft::bench {

using namespace agents;

namespace {

constexpr double kHalfWideM = 1.6;
constexpr double kHalfViewRad = 0.6545;
constexpr float kCameraM = 0.6F;
constexpr float kWallM = 2.2F;
constexpr float kRangeM = 5.0F;

/// Returns how far a ray goes over the floor to a wall of two corridors that cross at the origin; there are pillars.
double to_wall_m(const Eigen::Vector2d& from, const Eigen::Vector2d& ahead) {
  constexpr double step_m = 0.02;
  for (double range = 0.0; range < 8.0; range += step_m) {
    const Eigen::Vector2d at = from + range * ahead;
    const bool is_open = std::abs(at.x()) < kHalfWideM || std::abs(at.y()) < kHalfWideM;
    const double along = std::max(std::abs(at.x()), std::abs(at.y()));
    const double aside = std::min(std::abs(at.x()), std::abs(at.y()));
    const bool is_pillar = aside > kHalfWideM - 0.15 && std::fmod(along, 2.0) < 0.3 && along > 1.5;
    if (!is_open || is_pillar) return range;
  }
  return 8.0;
}

/// Returns a point that a camera sees in some direction; false: nothing within the range.
bool see(const Eigen::Vector3f& camera, double heading, Random& random, Eigen::Vector3f& point) {
  const double bearing = heading + random.uniform(-kHalfViewRad, kHalfViewRad);
  const auto slope = static_cast<float>(std::tan(random.uniform(-0.55, 0.55)));
  const Eigen::Vector2d ahead(std::cos(bearing), std::sin(bearing));
  const auto wall = static_cast<float>(to_wall_m(camera.head<2>().cast<double>(), ahead));
  const float floor = slope < 0.0F ? -camera.z() / slope : std::numeric_limits<float>::infinity();
  const float range = std::min(wall, floor);
  point.head<2>() = camera.head<2>() + range * ahead.cast<float>();
  point.z() = floor < wall ? 0.0F : camera.z() + slope * range;
  return (point - camera).norm() < kRangeM && point.z() < kWallM;
}

}  // namespace

std::vector<SeenCloud> crossing_clouds(std::size_t places, std::size_t points, Random& random) {
  std::vector<SeenCloud> clouds(places);
  for (std::size_t i = 0; i < places; ++i) {
    const bool is_along_x = i % 2 == 0;
    const double heading = is_along_x ? (i % 4 == 0 ? 0.0 : 3.14159) : (i % 4 == 1 ? 1.5708 : -1.5708);
    const double at = -2.0 + 4.0 * static_cast<double>(i) / static_cast<double>(places);
    for (int frame = 0; frame < 8; ++frame) {
      const double along = at + 0.12 * frame * (is_along_x ? std::cos(heading) : std::sin(heading));
      const double aside = random.normal(0.0, 0.05);
      clouds[i].cameras.emplace_back(static_cast<float>(is_along_x ? along : aside),
                                     static_cast<float>(is_along_x ? aside : along), kCameraM);
    }
    std::set<std::tuple<int, int, int>> voxels;
    for (std::size_t tried = 0; clouds[i].points.size() < points && tried < 60 * points; ++tried) {
      const auto frame = static_cast<std::uint16_t>(random.below(8));
      Eigen::Vector3f point;
      if (!see(clouds[i].cameras[frame], heading, random, point)) continue;
      const Eigen::Vector3i voxel = (point.array() / 0.05F).floor().cast<int>();
      if (!voxels.insert({voxel.x(), voxel.y(), voxel.z()}).second) continue;
      clouds[i].points.push_back({point, frame});
    }
  }
  return clouds;
}

Scan crossing_scan(const Pose2& chart_from_robot, Random& random) {
  Scan scan;
  for (double bearing = -kHalfViewRad; bearing < kHalfViewRad; bearing += 0.0087266) {
    const double heading = chart_from_robot.heading + bearing;
    const double range = to_wall_m(chart_from_robot.translation(), {std::cos(heading), std::sin(heading)});
    Beam beam{bearing, range + random.normal(0.0, 0.01 * range), 0.01 * range * range, range, Beam::Return::obstacle};
    if (range > static_cast<double>(kRangeM)) beam = {bearing, 0.0, 0.0, 3.0, Beam::Return::none};
    scan.beams.push_back(beam);
  }
  return scan;
}

}  // namespace weft::bench
