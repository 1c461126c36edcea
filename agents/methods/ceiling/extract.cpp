#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/methods/ceiling/known_mount.hpp"
#include "agents/methods/ceiling/rectified.hpp"
#include "agents/methods/image_of.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::agents {
namespace {

constexpr double kSameCornerPx = 4.0;  // features of the rectified ceiling lie that near to the corners followed

/// Returns what is told of the corner nearest to a pixel; nothing, where none is near.
ToldHeight told_at(const std::vector<Ceiling::Tracked>& tracks, const Eigen::Vector2d& pixel) {
  double nearest = kSameCornerPx * kSameCornerPx;
  ToldHeight told;
  for (const Ceiling::Tracked& track : tracks) {
    const double apart = (track.pixel - pixel).squaredNorm();
    if (apart >= nearest) continue;
    nearest = apart;
    told = together(track.told, track.tells);
  }
  return told;
}

/// Returns the part of a patch around the robot, at most so many pixels wide and high.
PlanePatch cut_out(const PlanePatch& whole, int most_px) {
  PlanePatch part;
  part.metres_per_pixel = whole.metres_per_pixel;
  part.width = std::min(whole.width, most_px);
  part.height = std::min(whole.height, most_px);
  const auto begin = [&](double first_m, int size, int of) {
    const auto middle = static_cast<int>(std::lround(first_m / whole.metres_per_pixel));
    return std::clamp(middle - size / 2, 0, of - size);
  };
  const int top = begin(whole.first_pixel_on_plane.x(), part.height, whole.height);
  const int left = begin(whole.first_pixel_on_plane.y(), part.width, whole.width);
  part.first_pixel_on_plane = whole.first_pixel_on_plane - whole.metres_per_pixel * Eigen::Vector2d(top, left);
  for (int row = top; row < top + part.height; ++row) {
    const auto from = whole.pixels.begin() + static_cast<std::ptrdiff_t>(row) * whole.width + left;
    part.pixels.insert(part.pixels.end(), from, from + part.width);
  }
  return part;
}

}  // namespace

OrRefusal<CeilingContent> Ceiling::extract(const Odometry& s, const View& view) const {
  constexpr double patch_m = 0.05;
  constexpr int spare = 2;  // times as many are looked for: of lamps' bloom none is kept
  const OrRefusal<const Image*> image = image_of(view, camera_);
  if (!image) return tl::unexpected(image.error());
  const std::optional<CeilingScale> known = scale(s);
  const std::optional<BirdsEye>& birds_eye = birds_eye_ ? birds_eye_ : s.birds_eye;
  if (!known || !birds_eye)
    return tl::unexpected<Refusal>(Refusal{"scale_unknown", s.wheels_m, config_.wheels_way_m});
  const double patch_px_m = std::max(patch_m, metres_per_pixel(config_, known->ceiling_m));
  RectifiedPlane seen = birds_eye->rectify(**image, spare * config_.features, patch_px_m);

  const double camera_m = camera_.robot_from_camera.translation.z();
  const HeightPrior prior = height_prior(config_, known->ceiling_m, camera_m);
  const bool is_newest = s.newest && s.frame == view.frame && s.inliers > 0;
  const Lamps lamps(**image, lamp_config(config_));
  const Eigen::Matrix3d here = camera_from_plane(camera_, Attitude{}, known->ceiling_m);
  CeilingContent content;
  for (PlaneFeature& feature : seen.features) {
    if (content.features.size() == static_cast<std::size_t>(config_.features)) break;
    const Eigen::Vector2d pixel = pixel_from_normalised(camera_, apply(here, feature.on_plane));
    if (!lamps.counts(pixel)) continue;
    const std::optional<Height> height = height_of(prior, is_newest ? told_at(s.tracks, pixel) : ToldHeight{});
    if (!height) continue;
    set_height(camera_, *height, feature);
    content.features.push_back(feature);
  }
  if (content.features.size() < static_cast<std::size_t>(config_.fewest_features))
    return tl::unexpected<Refusal>(Refusal{"too_blank", static_cast<double>(content.features.size()),
                                           static_cast<double>(config_.fewest_features)});
  content.camera = camera_;
  content.ceiling_m = known->ceiling_m;
  content.ceiling_sigma_m = known->sigma_m;
  content.patch = cut_out(seen.patch, widest_ceiling_patch_px);
  const Eigen::Vector3d vibration(config_.vibration_tilt_rad, config_.vibration_tilt_rad, config_.vibration_height_m);
  // A mount may have been knocked since its calibration: what drives have shown of it is believed, and no more.
  const MountTilt tilt = s.mount ? s.mount->tilt() : MountWatch(camera_, mount_prior(config_)).tilt();
  const Eigen::Vector3d mount2(tilt.covariance(0, 0), tilt.covariance(1, 1), 0.0);
  content.attitude = {tilt.pitch_rad, tilt.roll_rad, 0.0};
  content.attitude_sigma = (mount2 + vibration.cwiseAbs2()).cwiseSqrt();
  if (is_newest) {
    content.attitude = s.attitude;
    // Each fit counts its neighbours' noise as its own: the estimate is never taken for better than vibration.
    const Eigen::Vector3d fitted = s.attitude_covariance.diagonal().cwiseSqrt().cwiseMax(vibration);
    content.attitude_sigma.head<2>() = fitted.head<2>().cwiseMin(content.attitude_sigma.head<2>());
  }
  return content;
}

}  // namespace weft::agents
