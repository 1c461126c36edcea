#include "agents/methods/ceiling/ceiling.hpp"

#include <algorithm>
#include <string>

#include "agents/methods/ceiling/rectified.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/overlap.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::agents {

static_assert(Method<Ceiling> && Diagnoses<Ceiling> && Exposes<Ceiling> && Refines<Ceiling>);

std::string_view Ceiling::name_of(SeenBy by) {
  switch (by) {
    case SeenBy::corners:
      return "corners";
    case SeenBy::grey_values:
      return "grey_values";
    case SeenBy::features:
      return "features";
    case SeenBy::nothing:
      break;
  }
  return "nothing";
}

Ceiling::Ceiling(const CeilingConfig& config, const CameraModel& camera) : config_(config), camera_(camera) {
  if (config_.height_m > 0.0) birds_eye_.emplace(camera, rectified_area(config_, camera, config_.height_m));
}

Result<Ceiling> Ceiling::make(const CeilingConfig& config, const CameraModel& camera) {
  if (const Result<void> sound = check(camera); !sound) return fail(sound.error());
  if (const std::vector<std::string> issues = check(config); !issues.empty()) {
    std::string all;
    for (const std::string& issue : issues) all += (all.empty() ? "" : "; ") + issue;
    return fail(ErrorCode::invalid, all);
  }
  const double camera_m = camera.robot_from_camera.translation.z();
  if (config.height_m > 0.0 && config.height_m < camera_m + config.least_above_m)
    return fail(ErrorCode::invalid, "ceiling.height_m = " + std::to_string(config.height_m) + " is not " +
                                        std::to_string(config.least_above_m) + " m above camera \"" + camera.id +
                                        "\", which is mounted at " + std::to_string(camera_m) + " m");
  if (gaze_of(camera) != Gaze::up)
    return fail(ErrorCode::invalid, "camera \"" + camera.id + "\" does not look up; correct its mount");
  return Ceiling(informed(config, camera.sigma), camera);
}

std::optional<CeilingScale> Ceiling::scale(const Odometry& odometry) const {
  if (config_.height_m > 0.0) return CeilingScale{config_.height_m, config_.height_sigma_m};
  return odometry.scale_by_wheels;
}

double Ceiling::working_height_m(const Odometry& odometry) const {
  constexpr double supposed_m = 3.0;  // above the camera; any would do, as all scales with it
  const std::optional<CeilingScale> known = scale(odometry);
  return known ? known->ceiling_m : camera_.robot_from_camera.translation.z() + supposed_m;
}

Eigen::Vector2d Ceiling::gaze(const Content& content) const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const PlaneFeature& feature : content.features) sum += feature.on_plane;
  return sum / std::max(1.0, static_cast<double>(content.features.size()));
}

}  // namespace weft::agents
