#include "clients/evaluate/registration/stereo_run.hpp"

#include <cmath>
#include <numbers>

namespace weft::evaluate::registration {
namespace {

constexpr double kFrameM = 0.125;
constexpr int kPatchPx = 16;
constexpr double kMarkM = 0.2;  // edge of the patches of a wall that stereo sees or does not

/// Returns a number in [0, 1) that is the same for all points of one patch of a box.
double of_patch(std::size_t box, const Eigen::Vector3d& point) {
  std::uint64_t seed = box + 1;
  for (int axis = 0; axis < 3; ++axis) {
    seed = seed * 1'000'003U + static_cast<std::uint64_t>(std::llround(std::floor(point[axis] / kMarkM)) + 500'000);
  }
  return Random(seed).uniform();
}

/// Draws what neighbouring disparities have in common: a number for each patch of the image.
class PatchErrors {
 public:
  PatchErrors(const StereoRig& rig, Random& random)
      : columns_(rig.width_px / kPatchPx + 2),
        errors_(static_cast<std::size_t>(columns_ * (rig.height_px / kPatchPx + 2))) {
    for (double& error : errors_) error = random.normal(0.0, rig.patch_sigma_px);
  }
  /// Interpolates between the patches.
  double at(int u, int v) const {
    const int column = u / kPatchPx;
    const int row = v / kPatchPx;
    const double right = static_cast<double>(u % kPatchPx) / kPatchPx;
    const double down = static_cast<double>(v % kPatchPx) / kPatchPx;
    return (1 - down) * ((1 - right) * of(column, row) + right * of(column + 1, row)) +
           down * ((1 - right) * of(column, row + 1) + right * of(column + 1, row + 1));
  }

 private:
  double of(int column, int row) const { return errors_[static_cast<std::size_t>(row * columns_ + column)]; }

  int columns_;
  std::vector<double> errors_;
};

/// Returns the points that a frame gives, in the robot's frame.
std::vector<Eigen::Vector3f> seen_points(const Scene& scene, const Pose2& world_from_robot, const StereoRig& rig,
                                         double bias_px, Random& random) {
  const Pose3 pose = lift(world_from_robot);
  const Eigen::Vector3d mount(0.0, 0.0, rig.height_m);
  const Eigen::Vector3d camera = pose * mount;
  const PatchErrors patches(rig, random);
  std::vector<Eigen::Vector3f> points;
  for (int v = 0; v < rig.height_px; v += rig.every_px) {
    for (int u = 0; u < rig.width_px; u += rig.every_px) {
      const Eigen::Vector3d ray(1.0, (0.5 * rig.width_px - u) / rig.focal_px,
                                (0.5 * rig.height_px - v) / rig.focal_px);
      const Eigen::Vector3d ray_in_world = pose.rotation * ray;
      const auto met = first_met(scene, camera, ray_in_world, 2.0 * rig.range_m);
      if (!met || of_patch(met->box, camera + met->distance * ray_in_world) >= scene.boxes[met->box].seen) continue;
      double disparity = rig.focal_px * rig.baseline_m / met->distance + bias_px + patches.at(u, v) +
                         random.normal(0.0, rig.pixel_sigma_px);
      if (random.chance(rig.wild_share)) disparity += random.uniform(-6.0, 6.0);
      const double depth = rig.focal_px * rig.baseline_m / disparity;
      const Eigen::Vector3d point = mount + depth * ray;
      if (depth > 0.0 && depth <= rig.range_m && point.z() < rig.ceiling_m) points.emplace_back(point.cast<float>());
    }
  }
  return points;
}

}  // namespace

agents::DepthNoise StereoRig::noise() const {
  return {focal_px, baseline_m, std::hypot(pixel_sigma_px, patch_sigma_px)};
}

std::vector<MadePlace> run_through(const Scene& scene, const Pose2& start, double length_m, double spacing_m,
                                   const StereoRig& rig, Random& random) {
  const double bias_px = random.normal(0.0, rig.bias_sigma_px);
  const agents::CloudWindowConfig config;
  agents::CloudWindow window(config, rig.noise());
  std::vector<MadePlace> places;
  Pose2 truth = start;
  Pose3 odometry = lift(start);
  double since_place_m = 0.0;
  for (double at = 0.0; at <= length_m; at += kFrameM) {
    window.add(
        {odometry, seen_points(scene, truth, rig, bias_px, random), {0.0F, 0.0F, static_cast<float>(rig.height_m)}});
    const bool is_due = places.empty() || since_place_m > spacing_m - 1e-9;
    if (window.size() == config.frames && is_due) {
      places.push_back({window.snapshot(odometry), lift(truth)});
      since_place_m = 0.0;
    }
    const Pose2 step{kFrameM, 0.0, 0.0};
    const double turn_rad = random.normal(0.0, 0.05 * std::numbers::pi / 180.0);
    truth = truth * step;
    odometry = odometry * lift(step) * lift(Pose2{random.normal(0.0, 0.001), random.normal(0.0, 0.001), turn_rad});
    since_place_m += kFrameM;
  }
  return places;
}

}  // namespace weft::evaluate::registration
