#include "agents/perception/plane/level_points.hpp"

#include <Eigen/LU>

#include "agents/perception/plane/geometry.hpp"

namespace weft::agents {
namespace {

Eigen::Matrix3d level_from_mount(const CameraModel& camera, const Attitude& attitude, double above_floor_m) {
  return camera_from_plane(camera, attitude, above_floor_m).inverse() *
         camera_from_plane(camera, Attitude{}, above_floor_m);
}

}  // namespace

std::vector<Eigen::Vector2d> level_points(const CameraModel& camera, const Attitude& attitude,
                                          std::span<const PlaneFeature> features) {
  std::vector<Eigen::Vector2d> points;
  if (features.empty()) return points;
  points.reserve(features.size());
  double above_floor_m = features.front().above_floor_m;  // of most features
  Eigen::Matrix3d here = level_from_mount(camera, attitude, above_floor_m);
  for (const PlaneFeature& feature : features) {
    if (feature.above_floor_m != above_floor_m) {
      above_floor_m = feature.above_floor_m;
      here = level_from_mount(camera, attitude, above_floor_m);
    }
    points.push_back(apply(here, feature.on_plane));
  }
  return points;
}

}  // namespace weft::agents
