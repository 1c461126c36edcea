#include <algorithm>
#include <cmath>

#include "agents/methods/floor/floor.hpp"
#include "agents/methods/image_of.hpp"

namespace weft::agents {

OrRefusal<FloorContent> Floor::extract(const Odometry& s, const View& view) const {
  const OrRefusal<const Image*> image = image_of(view, camera_);
  if (!image) return tl::unexpected(image.error());
  RectifiedPlane seen = birds_eye_.rectify(**image, config_.features, config_.patch_metres_per_pixel);
  if (seen.features.size() < static_cast<std::size_t>(config_.fewest_features))
    return tl::unexpected<Refusal>(Refusal{"too_blank", static_cast<double>(seen.features.size()),
                                           static_cast<double>(config_.fewest_features)});

  FloorContent content;
  content.camera = camera_;
  content.features = std::move(seen.features);
  content.patch = std::move(seen.patch);
  const Eigen::Vector3d mount(config_.mount_tilt_rad, config_.mount_tilt_rad,
                              std::hypot(config_.mount_height_m, config_.load_m));
  const Eigen::Vector3d vibration(config_.vibration_tilt_rad, config_.vibration_tilt_rad, config_.vibration_height_m);
  content.attitude_sigma = (mount.cwiseAbs2() + vibration.cwiseAbs2()).cwiseSqrt();
  if (s.newest && s.frame == view.frame && s.inliers > 0) {
    content.attitude = s.attitude;
    // Each fit counts its neighbours' noise as its own: the estimate is never taken for better than vibration.
    const Eigen::Vector3d fitted = s.attitude_covariance.diagonal().cwiseSqrt().cwiseMax(vibration);
    content.attitude_sigma.head<2>() =
        fitted.head<2>().cwiseMin(content.attitude_sigma.head<2>());  // height cannot be seen
  }
  return content;
}

Eigen::Vector2d Floor::gaze(const Content& content) const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const PlaneFeature& feature : content.features) sum += feature.on_plane;
  return sum / std::max(1.0, static_cast<double>(content.features.size()));
}

}  // namespace weft::agents
