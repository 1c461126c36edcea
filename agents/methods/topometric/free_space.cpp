#include "agents/methods/topometric/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace weft::agents {
namespace {

constexpr double kFreeSideM = 14.0;
constexpr double kFreeCellM = 0.1;
constexpr double kFreeSigmas = 2.0;  // of its depth, by which a point must lie in the middle of what is free
constexpr std::size_t kFewestStanding = 150;

constexpr int kClearBearings = 64;      // bits of a frame
constexpr double kWithinRange = 0.998;  // of the square of the range: rays of just this length are to be counted

/// Returns the angle that a camera sees.
double view_of(const StereoRig& rig) {
  return 2.0 * std::atan2(0.5 * rig.width, rig.focal_px);
}

/// Returns whether all cells up to so many away are free, the next ones at least.
bool is_free_around(const OccupancyGrid& grid, const Cell& cell, double within_m) {
  const int around = std::max(1, static_cast<int>(std::lround(within_m / kFreeCellM)));
  for (int row = -around; row <= around; ++row)
    for (int column = -around; column <= around; ++column)
      if (grid.at(Cell{cell.column + column, cell.row + row}) != CellState::free) return false;
  return true;
}

}  // namespace

std::uint64_t clear_bearings(const Scan& scan, const StereoRig& rig, double clear_m) {
  const double view_rad = view_of(rig);
  std::uint64_t clear = ~std::uint64_t{0};
  std::uint64_t seen = 0;
  for (const Beam& beam : scan.beams) {
    const auto part = static_cast<int>(std::floor((beam.bearing_rad / view_rad + 0.5) * kClearBearings));
    if (part < 0 || part >= kClearBearings) continue;
    const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(part);
    seen |= bit;
    if (beam.kind != Beam::Return::none || beam.clear_m < clear_m) clear &= ~bit;
  }
  return clear & seen;
}

void add_clear_rays(const TopometricContent& content, const Pose3& frame_from_place, const RayCastConfig& config,
                    double cell_m, SeenCloud& seen) {
  const PlaceCloud& cloud = content.cloud;
  const double part_rad = view_of(content.rig) / kClearBearings;
  for (std::size_t i = 0; i < std::min(cloud.clear_bearings.size(), cloud.cameras.size()); ++i) {
    const Pose3 camera = frame_from_place * cloud.place_from_frames[i] * content.rig.robot_from_camera;
    const Eigen::Vector3d ahead = camera.rotation * Eigen::Vector3d::UnitZ();
    const double heading = std::atan2(ahead.y(), ahead.x());
    const Eigen::Vector3d from = seen.cameras[i].cast<double>();
    const double reach2 = kWithinRange * config.range_m * config.range_m - from.z() * from.z();
    const double length_m = std::min(static_cast<double>(content.clear_m), std::sqrt(std::max(0.0, reach2)));
    const int rays = std::max(1, static_cast<int>(std::ceil(part_rad * length_m / cell_m)));
    for (int ray = 0; ray < kClearBearings * rays; ++ray) {
      if ((cloud.clear_bearings[i] >> static_cast<unsigned>(ray / rays) & 1U) == 0U) continue;
      const double bearing = heading + part_rad * ((ray + 0.5) / rays - 0.5 * kClearBearings);
      const Eigen::Vector3d to(from.x() + length_m * std::cos(bearing), from.y() + length_m * std::sin(bearing), 0.0);
      seen.points.push_back({to.cast<float>(), static_cast<std::uint16_t>(i)});
    }
  }
}

SeenCloud seen_cloud(const PlaceCloud& cloud, const Pose3& frame_from_place) {
  const Eigen::Matrix3f rotation = frame_from_place.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f translation = frame_from_place.translation.cast<float>();
  SeenCloud seen;
  seen.points.reserve(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    seen.points.push_back({rotation * cloud.points[i] + translation, cloud.frames[i]});
  for (const Eigen::Vector3f& camera : cloud.cameras) seen.cameras.emplace_back(rotation * camera + translation);
  return seen;
}

StandingInFree standing_in_free(const PlaceCloud& a, const PlaceCloud& b, const Pose3& a_from_b,
                                const RayCastConfig& config, const DepthNoise& noise) {
  StandingInFree standing{0.0, std::vector<std::uint8_t>(b.points.size(), 0)};
  RayCaster caster(square_raster(Eigen::Vector2d::Zero(), kFreeSideM, kFreeCellM), config);
  if (!caster.cast(seen_cloud(a, Pose3{}))) return standing;
  const OccupancyGrid grid = caster.grid();
  std::size_t known = 0;
  std::size_t through = 0;
  const SeenCloud seen = seen_cloud(b, a_from_b);
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    const SeenCloud::Point& point = seen.points[i];
    const auto z = static_cast<double>(point.at.z());
    if (z < 2.0 * config.floor_m || z > config.body_height_m) continue;
    const Cell cell = grid.raster.cell_at(point.at.head<2>().cast<double>());
    if (grid.at(cell) == CellState::unknown) continue;
    ++known;
    const auto range_m = static_cast<double>((point.at - seen.cameras[point.frame]).norm());
    if (!is_free_around(grid, cell, kFreeSigmas * noise.sigma_m(range_m))) continue;
    ++through;
    standing.is_point[i] = 1;
  }
  if (known >= kFewestStanding) standing.share = static_cast<double>(through) / static_cast<double>(known);
  return standing;
}

}  // namespace weft::agents
