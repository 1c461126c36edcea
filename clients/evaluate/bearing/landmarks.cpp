#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/hall/interior.hpp"
#include "agents/bodies/sim/hall/quad_scene.hpp"
#include "clients/evaluate/bearing/model.hpp"

namespace weft::evaluate::bearing {

using namespace agents;

namespace {

constexpr int kColumns = 8;  // of a grid over the image, one packet of rays for two rows
constexpr int kRows = 6;

/// Appends the horizontal distances, in metres, of what a camera there shows.
void look(const sim::QuadScene& scene, const CameraModel& camera, const Pose3& site_from_camera,
          std::vector<double>& distances) {
  const Eigen::Matrix3f turn = site_from_camera.rotation.toRotationMatrix().cast<float>();
  for (int row = 0; row < kRows; row += 2) {
    sim::RayPacket rays;
    for (std::size_t i = 0; i < sim::kRays; ++i) {
      const auto at = static_cast<int>(i);
      const int below = at / kColumns;
      const double u = (at % kColumns + 0.5) * camera.width / kColumns;
      const double v = (row + below + 0.5) * camera.height / kRows;
      const Eigen::Vector3f way =
          turn * Eigen::Vector3d((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0).cast<float>();
      rays.x[i] = way.x();
      rays.y[i] = way.y();
      rays.z[i] = way.z();
    }
    scene.cast(site_from_camera.translation.cast<float>(), rays);
    for (std::size_t i = 0; i < sim::kRays; ++i) {
      if (rays.quad[i] < 0) continue;
      distances.push_back(static_cast<double>(rays.distance[i] * std::hypot(rays.x[i], rays.y[i])));
    }
  }
}

}  // namespace

Result<double> landmark_distance_m(const sim::Site& site, const Course& course) {
  sim::SimBodyConfig config;
  config.site = site;
  config.robot = site.robots.front().name;
  const auto body = sim::make_sim_body(config);
  if (!body) return fail(body.error());
  const CameraModel camera = (*body)->rig().camera();
  const sim::QuadScene scene(sim::interior_of(site));
  std::vector<double> distances;
  for (const Pose2& site_from_place : course.site_from_place)
    look(scene, camera, lift(site_from_place) * camera.robot_from_camera, distances);
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace weft::evaluate::bearing
