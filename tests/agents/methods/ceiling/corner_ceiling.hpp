#pragma once
// A ceiling of mere corners and what would be stored of it: no image is rendered, so that long ways are cheap.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "agents/methods/ceiling/run_mosaic.hpp"
#include "agents/perception/attitude.hpp"
#include "agents/perception/lens.hpp"
#include "core/random.hpp"
#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"

namespace weft::test {

/// Holds what was stored of a place, and which corner each of its features is.
struct StoredCorners {
  agents::CeilingContent content;
  std::vector<std::size_t> corners;
};

/// Holds corners with descriptors of their own; a third of them hang up to 1.5 m below the ceiling.
class CornerCeiling {
 public:
  static constexpr double ceiling_m = 6.4;
  static constexpr double told_sigma_m = 0.2;  ///< how well odometry has told heights of corners that hang

  CornerCeiling(const Eigen::AlignedBox2d& around, std::uint64_t seed) {
    constexpr double each_m2 = 0.6;
    Random random(seed);
    const auto count = static_cast<std::size_t>(around.volume() / each_m2);
    for (std::size_t i = 0; i < count; ++i) {
      const double below = i % 3 == 0 ? random.uniform(0.3, 1.5) : 0.0;
      at.emplace_back(random.uniform(around.min().x(), around.max().x()),
                      random.uniform(around.min().y(), around.max().y()), ceiling_m - below);
      headings_.push_back(random.uniform(-3.1, 3.1));
      descriptors_.emplace_back();
      for (std::uint64_t& word : descriptors_.back()) word = random.next();
    }
  }

  /// Returns what a robot that sways a little stores: its attitude is not known, nor what hangs to better than
  /// `told_sigma_m`.
  StoredCorners stored_from(const Pose2& map_from_robot, Random& random) const {
    StoredCorners stored;
    agents::CeilingContent& content = stored.content;
    content.camera = camera;
    content.attitude_sigma = {0.001, 0.001, 0.001};
    content.ceiling_m = ceiling_m;
    content.ceiling_sigma_m = 0.05;
    content.patch.metres_per_pixel = 0.05;
    const agents::Attitude sway{random.normal(0.0, 0.0009), random.normal(0.0, 0.0009), random.normal(0.0, 0.0005)};
    const Pose3 camera_from_map =
        (lift(map_from_robot) * agents::level_from_body(sway) * camera.robot_from_camera).inverse();
    for (std::size_t i = 0; i < at.size() && content.features.size() < agents::most_ceiling_features; ++i) {
      const Eigen::Vector3d there = camera_from_map * at[i];
      if (!is_in_view(there)) continue;
      content.features.push_back(feature(i, there, map_from_robot.heading, random));
      stored.corners.push_back(i);
    }
    return stored;
  }

  agents::CameraModel camera = up_camera(0.03, -0.02);
  std::vector<Eigen::Vector3d> at;

 private:
  bool is_in_view(const Eigen::Vector3d& there) const {
    if (there.z() < 0.5 || there.head<2>().norm() > 1.4 * there.z()) return false;
    const Eigen::Vector2d pixel = agents::pixel_from_normalised(camera, there.hnormalized());
    return pixel.x() > 0.0 && pixel.y() > 0.0 && pixel.x() < camera.width - 1.0 && pixel.y() < camera.height - 1.0;
  }

  agents::PlaneFeature feature(std::size_t i, const Eigen::Vector3d& there, double heading, Random& random) const {
    constexpr double noise_m = 0.008;
    agents::PlaneFeature out;
    const bool hangs = at[i].z() < ceiling_m;
    out.above_floor_m =
        hangs ? std::clamp(at[i].z() + random.normal(0.0, told_sigma_m), ceiling_m - 2.5, ceiling_m) : ceiling_m;
    out.above_floor_sigma_m = hangs ? told_sigma_m : 0.02;
    const Eigen::Vector3d eye = camera.robot_from_camera.translation;
    const Eigen::Vector3d ray = camera.robot_from_camera.rotation * there;
    out.on_plane = (eye + (out.above_floor_m - eye.z()) / ray.z() * ray).head<2>() +
                   Eigen::Vector2d(random.normal(0.0, noise_m), random.normal(0.0, noise_m));
    out.heading_rad = wrap_angle(headings_[i] - heading + random.normal(0.0, 0.05));
    out.descriptor = descriptors_[i];
    for (int bit = 0; bit < 8; ++bit) out.descriptor[random.below(4)] ^= std::uint64_t{1} << random.below(64);
    return out;
  }

  std::vector<double> headings_;
  std::vector<agents::Descriptor> descriptors_;
};

/// Returns a box about a way, as wide as the camera sees from it.
inline Eigen::AlignedBox2d seen_about(const std::vector<Pose2>& way) {
  constexpr double beyond_m = 8.0;
  Eigen::AlignedBox2d around;
  for (const Pose2& pose : way) around.extend(pose.translation());
  return {around.min() - Eigen::Vector2d::Constant(beyond_m), around.max() + Eigen::Vector2d::Constant(beyond_m)};
}

/// Holds a run as odometry had it, 1 % too long and drifting, and where its places truly are.
struct TaughtUnder {
  TaughtUnder(const CornerCeiling& ceiling, std::vector<Pose2> way, std::uint64_t seed)
      : truth(std::move(way)), random(seed) {
    for (std::uint32_t i = 0; i < truth.size(); ++i) {
      StoredCorners stored = ceiling.stored_from(truth[i], random);
      corners.push_back(std::move(stored.corners));
      run.push_back({{experience, i}, std::make_shared<const agents::CeilingContent>(std::move(stored.content)), {}});
      if (i > 0) join(i - 1, i, {0.004, 0.004, 0.004}, 0.01, Origin::odometry);
    }
  }
  void stitch(std::uint32_t a, std::uint32_t b) { join(a, b, {0.01, 0.01, 0.003}, 0.0, Origin::stitch); }

  static constexpr ExperienceId experience{7};
  std::vector<Pose2> truth;
  agents::CeilingRun run;
  std::vector<std::vector<std::size_t>> corners;  ///< of each place's features
  Random random;

 private:
  void join(std::uint32_t a, std::uint32_t b, const Eigen::Vector3d& sigma, double longer, Origin origin) {
    const Pose2 moved = truth[a].inverse() * truth[b];
    const Eigen::Vector3d noise(longer * moved.x + random.normal(0.0, sigma.x()), random.normal(0.0, sigma.y()),
                                random.normal(0.0, sigma.z()));
    const Eigen::Vector3d variances = (sigma + Eigen::Vector3d(longer * std::abs(moved.x), 0.0, 0.0)).cwiseAbs2();
    Edge edge;
    edge.id = {{experience, a}, {experience, b}};
    edge.origin = origin;
    edge.a_from_b = Metric2{moved * se2_exp(noise), variances.asDiagonal()};
    run[b].edges.push_back(edge);
  }
};

}  // namespace weft::test
