#include <cmath>

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/methods/ceiling/rectified.hpp"
#include "agents/methods/image_of.hpp"
#include "agents/perception/exposure.hpp"
#include "agents/perception/lens.hpp"

namespace weft::agents {

std::vector<Diagnostic> Ceiling::diagnose(const Odometry& odometry) const {
  const std::optional<MountReport> report = odometry.mount ? odometry.mount->report() : std::nullopt;
  if (!report) return {};
  const MountTilt& tilt = report->tilt;
  std::vector<Diagnostic> all = {{"mount_pitch_rad", tilt.pitch_rad, tilt.sigma_rad(), 0.0},
                                 {"mount_roll_rad", tilt.roll_rad, tilt.sigma_rad(), 0.0}};
  if (config_.height_m > 0.0 && odometry.wheels_m >= config_.wheels_way_m && odometry.seen_m > 0.0)
    all.push_back({"ceiling_height_share", odometry.wheels_m / odometry.seen_m - 1.0, config_.wheels_scale, 0.0});
  return all;
}

std::optional<Exposure> Ceiling::expose(const Odometry& odometry, const View& view) const {
  const OrRefusal<const Image*> image = image_of(view, camera_);
  if (!image || !view.exposure) return std::nullopt;
  constexpr double followed = 0.5;     // of the power of 2 that is missing, an image: as agents/perception/exposure
  constexpr double most_factor = 4.0;  // likewise, and its inverse
  constexpr double driven_m_s = 1.0;   // robots are hardly faster
  const double grey = grey_beside_lamps(**image, lamp_config(config_));
  const double wanted = std::clamp(config_.mid_grey / std::max(grey, 1.0), 1.0 / most_factor, most_factor);
  const double away_m = working_height_m(odometry) - camera_.robot_from_camera.translation.z();
  return brightened(*view.exposure, std::pow(wanted, followed), driven_m_s * focal_px(camera_) / away_m, {});
}

}  // namespace weft::agents
