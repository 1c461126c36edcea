#include "agents/perception/mount_drive.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace weft::agents {
namespace {

constexpr double kYawBefore = 0.05;      // rad: 1 sigma of how a camera is put on by eye
constexpr double kForwardBefore = 0.02;  // m: measured with a ruler
constexpr int kPasses = 3;               // the first two find the mount, the last one says what it makes of the drive

std::string text(double value) {
  const std::string all = std::to_string(value);
  return all.substr(0, all.find('.') + 4);
}

bool is_ceiling(const MountDriveConfig& config) {
  return config.plane_m > 0.0;
}

/// Says where a drive shows enough.
std::string good_ground(const MountDriveConfig& config) {
  return is_ceiling(config) ? "below a ceiling with beams, joints or pipes" : "over a floor with texture";
}

Result<void> check_drive(const DriveSeen& played, const MountDriveConfig& config) {
  if (played.path_m < config.least_drive_m)
    return fail(ErrorCode::refused, "the drive is " + text(played.path_m) + " m long, at least " +
                                        text(config.least_drive_m) + " m are needed; drive further, 5 m or more");
  const double blind = static_cast<double>(played.blind) / static_cast<double>(played.samples);
  if (blind > config.most_blind_share)
    return fail(ErrorCode::refused, text(100.0 * blind) + " % of the images show no " +
                                        (is_ceiling(config) ? "ceiling" : "floor") +
                                        " that can be followed, at most " + text(100.0 * config.most_blind_share) +
                                        " % are allowed; drive slower, " + good_ground(config) +
                                        ", in good light, and begin with a mount that is right to 5 degrees");
  return {};
}

/// Sets the share of the focal length's error that distances keep when the height has been found with it: another
/// drive is another mixture of straights and bends (docs/decisions/024-odometry-candidates.md).
constexpr double kScaleByFocal = 0.15;

struct FoundHeight {
  HeightFrom from = HeightFrom::nothing;
  double share = 0.0;
  std::optional<double> scale_sigma;
};

/// Finds by what share the height is wrong: distances as seen are proportional to the height that was believed.
Result<FoundHeight> height_from(const DriveSeen& played, const MountDriveConfig& config) {
  const double seen_m = played.first_from_last.translation().norm();
  if (config.distance_m.has_value()) {
    if (seen_m < 0.5 * config.least_drive_m)
      return fail(ErrorCode::refused, "first and last stand are " + text(seen_m) +
                                          " m apart as seen; a measured distance needs a drive that ends " +
                                          text(0.5 * config.least_drive_m) + " m or more from where it began");
    // Over a floor odometry itself is good to 0.2 % of a metre.
    const double odometry = is_ceiling(config) ? kCeilingScale : 0.002 / std::sqrt(seen_m);
    return FoundHeight{
        HeightFrom::distance, *config.distance_m / seen_m - 1.0,
        std::hypot(config.distance_sigma_m / *config.distance_m, odometry, kScaleByFocal * config.prior.focal_share)};
  }
  if (config.wheels_sigma.has_value() && played.seen_beside_m > 0.5 * config.least_drive_m)
    return FoundHeight{HeightFrom::wheels, played.wheels_m / played.seen_beside_m - 1.0,
                       std::hypot(*config.wheels_sigma, 0.002, kScaleByFocal * config.prior.focal_share)};
  return FoundHeight{};
}

/// Takes the height in: of the floor's camera, or of the ceiling.
void take_height(const FoundHeight& height, const MountDriveConfig& config, MountDrive& out) {
  out.height_from = height.from;
  out.scale_sigma = height.scale_sigma;
  double& camera_m = out.camera.robot_from_camera.translation.z();
  if (is_ceiling(config)) {
    out.plane_m = camera_m + (1.0 + height.share) * (out.plane_m - camera_m);
    return;
  }
  out.camera.sigma.scale_share = height.scale_sigma;
  camera_m *= 1.0 + height.share;
}

/// Turns the mount as the drive's views and its base's motions show; false: too little was seen.
bool turn_mount(const std::vector<PlaneViews>& seen, const MountDriveConfig& config, MountDrive& out) {
  MountFilter filter(out.camera, config.prior);
  std::vector<Pose2> motions;
  for (const PlaneViews& views : seen) {
    if (filter.add(views)) motions.push_back(views.a_from_b);
  }
  const MountTilt tilt = filter.tilt();
  out.pairs = filter.pairs();
  out.camera.sigma.tilt_rad = tilt.sigma_rad();
  if (tilt.sigma_rad() > config.most_tilt_sigma_rad) return false;
  out.camera = tilted(out.camera, tilt.pitch_rad, tilt.roll_rad);
  out.pitch_rad += tilt.pitch_rad;
  out.roll_rad += tilt.roll_rad;
  const std::optional<MountLever> lever = lever_from(motions, kYawBefore, kForwardBefore);
  if (!lever.has_value()) return true;
  out.camera = shifted(out.camera, *lever);
  out.lever = {out.lever.yaw_rad + lever->yaw_rad, out.lever.forward_m + lever->forward_m, lever->yaw_sigma_rad,
               lever->forward_sigma_m};
  out.yaw_seen = lever->yaw_sigma_rad < 0.5 * kYawBefore;
  out.forward_seen = lever->forward_sigma_m < 0.5 * kForwardBefore;
  out.camera.sigma.yaw_rad = lever->yaw_sigma_rad;
  return true;
}

}  // namespace

std::optional<double> MountDrive::plane_sigma_m() const {
  constexpr double least_m = 0.001;  // no tape is better
  if (!scale_sigma) return std::nullopt;
  return std::max(least_m, *scale_sigma * (plane_m - camera.robot_from_camera.translation.z()));
}

Result<MountDrive> find_mount(const CameraModel& given, const SeeDrive& see, const MountDriveConfig& config) {
  MountDrive out;
  out.camera = given;
  out.plane_m = config.plane_m;
  out.camera.sigma.focal_share = config.prior.focal_share;
  out.camera.sigma.tilt_rad = out.camera.sigma.yaw_rad = out.camera.sigma.scale_share = std::nullopt;  // of before
  DriveSeen seen;
  double height_share = 0.0;
  for (int pass = 0; pass < kPasses; ++pass) {
    Result<DriveSeen> once = see(out.camera, out.plane_m);
    if (!once) return fail(once.error());
    seen = std::move(*once);
    if (const Result<void> good = check_drive(seen, config); !good) return fail(good.error());
    const Result<FoundHeight> height = height_from(seen, config);
    if (!height) return fail(height.error());
    height_share = (1.0 + height_share) * (1.0 + height->share) - 1.0;
    take_height(*height, config, out);
    if (pass == 0) out.seen_m = seen.first_from_last.translation().norm();
    if (pass + 1 == kPasses) break;  // only the height is left to be found with the final mount

    if (!turn_mount(seen.views, config, out))
      return fail(ErrorCode::refused, "pitch and roll are only known to " + text(*out.camera.sigma.tilt_rad) +
                                          " rad, the bound is " + text(config.most_tilt_sigma_rad) +
                                          "; drive further " + good_ground(config) +
                                          ", and calibrate the camera first");
  }
  out.height_share = height_share;
  out.path_m = seen.path_m;
  out.samples = seen.samples;
  out.blind = seen.blind;
  return out;
}

}  // namespace weft::agents
