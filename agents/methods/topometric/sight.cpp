#include "agents/methods/topometric/sight.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::agents {
namespace {

constexpr double kFloorSigmaM = 0.005;    // of a floor itself, and of what matching does to it
constexpr double kFloorPriorM = 0.01;     // by which a robot bounces between two views
constexpr double kFloorPriorRad = 0.006;  // by which it nods
constexpr double kMostOffMountM = 0.1;
constexpr int kFloorRounds = 3;

/// Is the plane z = height + slope_x x + slope_y y.
using FloorPlane = Eigen::Vector3d;

double off_plane_m(const FloorPlane& plane, const Eigen::Vector3d& point) {
  return point.z() - plane.dot(Eigen::Vector3d(1.0, point.x(), point.y()));
}

/// Holds the sums of a fit of a plane that begins as level as the view before.
struct FloorSums {
  Eigen::Matrix3d information =
      Eigen::Vector3d(1.0 / (kFloorPriorM * kFloorPriorM), 1.0 / (kFloorPriorRad * kFloorPriorRad),
                      1.0 / (kFloorPriorRad * kFloorPriorRad))
          .asDiagonal();
  Eigen::Vector3d told = Eigen::Vector3d::Zero();
  std::size_t points = 0;

  void add(const Eigen::Vector3d& point, double sigma_m) {
    // Neighbouring pixels err alike: a few hundred of them tell as much as one by itself.
    constexpr double worth = 1.0 / 50.0;
    const double weight = worth / (sigma_m * sigma_m);
    const Eigen::Vector3d row(1.0, point.x(), point.y());
    information += weight * row * row.transpose();
    told += weight * point.z() * row;
    ++points;
  }
  FloorPlane plane() const { return information.ldlt().solve(told); }
};

/// Returns from how far before the lenses on a thing of that height is seen: above the image's lower edge, and not
/// too near to be matched.
double in_view_from_m(const StereoRig& rig, const DisparityConfig& disparity, double height_m) {
  const double most_px = disparity.disparities - 2;
  const Eigen::Vector3d lowest =
      rig.robot_from_camera.rotation * Eigen::Vector3d(0.0, (rig.height - 1 - rig.cy) / rig.focal_px, 1.0);
  const double down = -lowest.z() / lowest.head<2>().norm();
  const double above_m = std::max(0.0, rig.robot_from_camera.translation.z() - height_m);
  return std::max(rig.depth_m(most_px), down > 0.0 ? above_m / down : std::numeric_limits<double>::infinity());
}

/// Takes back what is clear near the left edge of the left image: what stands as near as rays begin to clear lies
/// left of the right one there and cannot be matched, while what is far behind it can.
void clear_nothing_at_the_edge(const StereoRig& rig, Scan& scan) {
  const double least_px = rig.disparity_px(scan.clear_from_m);
  for (Beam& beam : scan.beams)
    if (rig.cx - rig.focal_px * std::tan(beam.bearing_rad) < least_px) beam.clear_m = 0.0;
}

}  // namespace

double sight_range_m(const SightConfig& config, const StereoRig& rig) {
  const double certain_m =
      std::sqrt(config.most_depth_sigma_m * rig.focal_px * rig.baseline_m / config.disparity_sigma_px);
  return std::min(config.range_m, certain_m);
}

PseudoScanConfig scan_of_pair(PseudoScanConfig scan, const SightConfig& sight, const DisparityConfig& disparity,
                              const StereoRig& rig) {
  scan.clear_from_m = std::min(in_view_from_m(rig, disparity, scan.slice_from_m), scan.range_m);
  scan.field_of_view_rad = 2.0 * std::atan2(0.5 * rig.width, rig.focal_px) + 2.0 * scan.bin_rad;
  scan.sigma_by_square_1_m = sight.disparity_sigma_px / (rig.focal_px * rig.baseline_m);
  scan.range_m = std::min(scan.range_m, sight_range_m(sight, rig));
  return scan;
}

Pose3 level_above(const Eigen::Vector3d& up, double height_m) {
  Pose3 level_from_robot;
  level_from_robot.rotation = Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ());
  level_from_robot.translation = {0.0, 0.0, height_m};
  return level_from_robot;
}

std::optional<FloorOfView> fit_floor(std::span<const Eigen::Vector3f> in_robot, const StereoRig& rig,
                                     const Pose3& level_from_robot_before, const SightConfig& config) {
  const Eigen::Vector3d camera = level_from_robot_before * rig.robot_from_camera.translation;
  std::vector<Eigen::Vector3d> near;
  for (const Eigen::Vector3f& point : in_robot) {
    const Eigen::Vector3d level = level_from_robot_before * Eigen::Vector3d(point.cast<double>());
    if (std::abs(level.z()) < config.floor_within_m) near.push_back(level);
  }
  FloorPlane plane = FloorPlane::Zero();
  std::size_t points = 0;
  double within_m = config.floor_within_m;
  for (int round = 0; round < kFloorRounds; ++round, within_m = std::max(0.03, 0.5 * within_m)) {
    FloorSums sums;
    for (const Eigen::Vector3d& point : near) {
      if (std::abs(off_plane_m(plane, point)) > within_m) continue;
      // A depth that is off moves a point of the floor along its ray, and so up or down by the ray's slope.
      const double away_m = (point - camera).norm();
      const double slope = (camera.z() - point.z()) / away_m;
      sums.add(point, std::hypot(kFloorSigmaM, slope * rig.depth_sigma_m(away_m, config.disparity_sigma_px)));
    }
    if (sums.points < static_cast<std::size_t>(config.fewest_floor_points)) return std::nullopt;
    plane = sums.plane();
    points = sums.points;
  }
  const Eigen::Vector3d up = Eigen::Vector3d(-plane.y(), -plane.z(), 1.0).normalized();
  const Eigen::Vector3d up_in_robot = level_from_robot_before.rotation.inverse() * up;
  const Eigen::Vector3d origin = level_from_robot_before * Eigen::Vector3d(Eigen::Vector3d::Zero());
  const double height_m = up.dot(origin - Eigen::Vector3d(0.0, 0.0, plane.x()));
  const double tilt_rad = std::acos(std::clamp(up_in_robot.z(), -1.0, 1.0));
  if (tilt_rad > config.most_floor_tilt_rad || std::abs(height_m) > kMostOffMountM) return std::nullopt;
  return FloorOfView{level_above(up_in_robot, height_m), points};
}

OrUnseen<Sight> look_with(const TopometricConfig& config, const StereoRig& rig, const StereoPair& rectified,
                          const Pose3& level_from_robot_before) {
  const OrUnseen<DisparityMap> map = match_disparity(config.disparity, rectified);
  if (!map) return tl::unexpected(map.error());
  Sight sight;
  const double range_m = sight_range_m(config.sight, rig);
  const std::vector<DepthPoint> seen = points_of(*map, rig, std::max(range_m, config.scan.past_m),
                                                 config.sight.disparity_sigma_px, config.sight.every_px);
  const Eigen::Matrix3f rotation = rig.robot_from_camera.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f translation = rig.robot_from_camera.translation.cast<float>();
  sight.in_robot.reserve(seen.size());
  std::vector<Eigen::Vector3f> past;  // beyond the range
  for (const DepthPoint& point : seen) {
    const Eigen::Vector3f in_robot = rotation * point.in_camera + translation;
    if (static_cast<double>(in_robot.z()) > config.sight.highest_m) continue;
    (static_cast<double>(point.in_camera.z()) <= range_m ? sight.in_robot : past).push_back(in_robot);
  }
  const auto floor = fit_floor(sight.in_robot, rig, level_from_robot_before, config.sight);
  sight.level_from_robot = floor ? floor->level_from_robot : level_from_robot_before;

  const Pose3 level_from_camera = sight.level_from_robot * rig.robot_from_camera;
  const Eigen::Vector3d ahead = level_from_camera.rotation * Eigen::Vector3d::UnitZ();
  const Pose2 robot_from_scan{level_from_camera.translation.x(), level_from_camera.translation.y(),
                              std::atan2(ahead.y(), ahead.x())};
  const Pose3 scan_from_robot = lift(robot_from_scan).inverse() * sight.level_from_robot;
  const Eigen::Matrix3f level_rotation = scan_from_robot.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f level_translation = scan_from_robot.translation.cast<float>();
  std::vector<Eigen::Vector3f> level;
  level.reserve(sight.in_robot.size() + past.size());
  for (const auto* points : {&sight.in_robot, &past})
    for (const Eigen::Vector3f& point : *points) level.emplace_back(level_rotation * point + level_translation);
  sight.scan = pseudo_scan(config.scan, level, robot_from_scan);
  clear_nothing_at_the_edge(rig, sight.scan);
  return sight;
}

}  // namespace weft::agents
