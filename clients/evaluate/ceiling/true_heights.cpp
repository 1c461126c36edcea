#include "clients/evaluate/ceiling/true_heights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "agents/bodies/sim/hall/interior.hpp"
#include "agents/bodies/sim/hall/quad_scene.hpp"
#include "agents/perception/lens.hpp"
#include "core/geometry/pose3.hpp"

namespace weft::evaluate::ceiling {
namespace {

using namespace agents;

constexpr double kHangsM = 0.2;  // below the ceiling: what is nearer to it is the ceiling
constexpr double kJudgedAtM = 5.0;
constexpr double kMostSigmas = 3.0;

/// Returns the height nearest to `said_m` of what is seen around a corner; not a number: nothing is there.
double height_around(const sim::QuadScene& scene, const Pose3& site_from_camera, const CameraModel& camera,
                     const SeenHeight& corner) {
  const double said_m = corner.height.above_floor_m;
  double best_m = std::numeric_limits<double>::quiet_NaN();
  for (const double aside_px : {-3.0, 0.0, 3.0}) {
    for (const double down_px : {-3.0, 0.0, 3.0}) {
      const Eigen::Vector2d near = corner.in_view + Eigen::Vector2d(aside_px, down_px) / focal_px(camera);
      const Eigen::Vector3d way = (site_from_camera.rotation * near.homogeneous().eval()).normalized();
      const double distance_m = scene.distance_m(site_from_camera.translation.cast<float>(), way.cast<float>());
      const double height_m = site_from_camera.translation.z() + distance_m * way.z();
      if (!std::isfinite(height_m)) continue;
      if (!std::isfinite(best_m) || std::abs(height_m - said_m) < std::abs(best_m - said_m)) best_m = height_m;
    }
  }
  return best_m;
}

}  // namespace

HeightErrors judge_heights(const sim::Site& site, const CameraModel& camera, const std::vector<SeenHeight>& seen,
                           const floor::Trace& trace) {
  const sim::QuadScene scene(sim::interior_of(site));
  HeightErrors errors;
  for (const SeenHeight& corner : seen) {
    const Pose3 site_from_camera = lift(trace.moments.at(corner.sample).site_from_robot) * camera.robot_from_camera;
    const double truth_m = height_around(scene, site_from_camera, camera, corner);
    if (!std::isfinite(truth_m)) continue;
    const double off_m = std::abs(corner.height.above_floor_m - truth_m);
    ++errors.all;
    if (off_m > kMostSigmas * corner.height.sigma_m) ++errors.beyond;
    const double away_m = truth_m - camera.robot_from_camera.translation.z();
    if (truth_m < site.hall.ceiling_m - kHangsM && away_m > 0.0)
      errors.hanging_m.push_back(off_m * kJudgedAtM / away_m);
  }
  return errors;
}

double upper_quartile(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at = values.begin() + static_cast<std::ptrdiff_t>((3 * values.size() + 3) / 4 - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace weft::evaluate::ceiling
