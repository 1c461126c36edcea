#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "agents/methods/floor/floor.hpp"
#include "agents/perception/homography.hpp"
#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

/// The shared fallback, kept in the keyframe's account so that the next tracked view takes its error back.
Step blind(Floor::Odometry& s, const Step& reckoned, std::string_view reason) {
  s.keyframe_from_robot = s.keyframe_from_robot * planar(reckoned.previous_from_current);
  return {reckoned.previous_from_current, false, reason};
}

/// The newest view becomes the keyframe.
void begin_keyframe(const FloorConfig& c, const CameraModel& camera, Floor::Odometry& s) {
  s.keyframe_sway = s.sway;
  s.keyframe_sway_covariance = s.sway_covariance;
  s.keyframe_from_robot = Pose2{};
  s.wheels = Pose2{};
  s.tracks.clear();
  CornerConfig corners;
  corners.count = c.corners;
  corners.border_px = c.window_px / 2 + 3;
  for (const Eigen::Vector2d& pixel : find_corners(s.newest, corners))
    s.tracks.push_back({normalised_from_pixel(camera, pixel), pixel});
  s.keyframe_tracks = s.tracks.size();
}

/// Nothing is known about the sway but the mount's calibration and the vibration.
void forget_sway(const FloorConfig& c, Floor::Odometry& s) {
  const double tilt = c.mount_tilt_rad * c.mount_tilt_rad + c.vibration_tilt_rad * c.vibration_tilt_rad;
  const double lift = c.mount_height_m * c.mount_height_m + c.vibration_height_m * c.vibration_height_m;
  s.sway = Sway{};
  s.sway_covariance = Eigen::Vector3d(tilt, tilt, lift).asDiagonal();
}

/// After a blind stretch: the mount's tilt is still known, this view's vibration is not.
void begin_keyframe_unseen(const FloorConfig& c, const CameraModel& camera, Floor::Odometry& s) {
  const double tilt = c.vibration_tilt_rad * c.vibration_tilt_rad;
  s.sway_covariance.diagonal() += Eigen::Vector3d(tilt, tilt, c.vibration_height_m * c.vibration_height_m);
  begin_keyframe(c, camera, s);
}

/// The keyframe's sway as it was estimated; the newest one differs from it by vibration. Tilt is left to the floor
/// beyond that (its perspective shows in every motion); height cannot be seen in one camera's motion, so it is held
/// by the calibration.
SwayPrior sway_prior(const FloorConfig& c, const Floor::Odometry& s) {
  const auto information = [](double tilt, double lift) -> Eigen::Matrix3d {
    return Eigen::Vector3d(1.0 / (tilt * tilt), 1.0 / (tilt * tilt), 1.0 / (lift * lift)).asDiagonal();
  };
  const double root2 = std::sqrt(2.0);
  const Eigen::Matrix3d together = information(root2 * c.vibration_tilt_rad, root2 * c.vibration_height_m);
  const Eigen::Matrix3d keyframe = s.keyframe_sway_covariance.ldlt().solve(Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d loose = information(3.0 * c.mount_tilt_rad, c.mount_height_m);
  SwayPrior prior;
  prior.information.topLeftCorner<3, 3>() = keyframe + together;
  prior.information.topRightCorner<3, 3>() = -together;
  prior.information.bottomLeftCorner<3, 3>() = -together;
  prior.information.bottomRightCorner<3, 3>() = together + loose;
  Vector6d pull = Vector6d::Zero();
  pull.head<3>() = keyframe * s.keyframe_sway.vector();
  prior.mean = prior.information.ldlt().solve(pull);
  return prior;
}

/// What the keyframe and the newest view show of the mount.
FloorViews views_of(const FloorConfig& c, const CameraModel& camera, const Floor::Odometry& s) {
  FloorViews views{{}, s.keyframe_from_robot, s.wheels};
  for (const Floor::Tracked& t : s.tracks)
    views.points.push_back({t.in_keyframe, normalised_from_pixel(camera, t.pixel), c.track_sigma_px});
  return views;
}

MountPrior mount_prior(const FloorConfig& c) {
  MountPrior prior;
  prior.tilt_rad = 3.0 * c.mount_tilt_rad;  // mounts get knocked
  prior.vibration_tilt_rad = c.vibration_tilt_rad;
  prior.vibration_height_m = c.vibration_height_m;
  return prior;
}

void roll(const Motion& motion, std::optional<Pose2>& wheels) {
  if (!motion.wheels.has_value()) wheels.reset();
  if (wheels.has_value())
    wheels = *wheels * exp2(Eigen::Vector3d(motion.wheels->distance_m, 0.0, motion.wheels->heading_rad));
}

struct Followed {
  std::vector<Floor::Tracked> tracks;  ///< ordered by how well the window fits
  std::vector<FloorPair> pairs;
};

Followed follow(const CameraModel& camera, const FloorConfig& c, const Floor::Odometry& s, const TrackingImage& image,
                const PlanarState& expected) {
  std::vector<Eigen::Vector2d> from;
  std::vector<Eigen::Vector2d> guess;
  for (const Floor::Tracked& t : s.tracks) {
    from.push_back(t.pixel);
    const Reprojection there = reproject(camera, camera, expected, t.in_keyframe);
    guess.push_back(there.in_front ? pixel_from_normalised(camera, there.in_b) : t.pixel);
  }
  const std::vector<Track> found = track_corners(s.newest, image, from, guess);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i].found) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t x, std::size_t y) { return found[x].error < found[y].error; });
  Followed out;
  for (const std::size_t i : order) {
    out.tracks.push_back({s.tracks[i].in_keyframe, found[i].pixel});
    out.pairs.push_back({s.tracks[i].in_keyframe, normalised_from_pixel(camera, found[i].pixel), c.track_sigma_px});
  }
  return out;
}

/// Keeps the pairs for which `keep` holds, in both lists.
template <class Keep>
void retain(Followed& followed, const Keep& keep) {
  Followed kept;
  for (std::size_t i = 0; i < followed.pairs.size(); ++i)
    if (keep(i)) {
      kept.pairs.push_back(followed.pairs[i]);
      kept.tracks.push_back(followed.tracks[i]);
    }
  followed = std::move(kept);
}

/// Eq. 1 and 2: the pairs that one plane explains, and the decomposition's word on whether that plane is the floor.
std::string_view refused_by_homography(const CameraModel& camera, const FloorConfig& c, const PlanarState& expected,
                                       Followed& followed) {
  const std::size_t found = followed.pairs.size();
  const auto fewest = static_cast<std::size_t>(c.fewest_tracks);
  if (found < fewest) return "few_tracks";
  std::vector<Eigen::Vector2d> a;
  std::vector<Eigen::Vector2d> b;
  for (const FloorPair& pair : followed.pairs) {
    a.push_back(pair.in_a);
    b.push_back(pair.in_b);
  }
  const auto homography = robust_homography(a, b, c.homography_px / focal_px(camera));
  if (!homography) return "homography_refused";
  if (homography->inliers < fewest ||
      static_cast<double>(homography->inliers) < c.fewest_tracks_share * static_cast<double>(found))
    return "few_tracks";
  retain(followed, [&](std::size_t i) { return homography->inlier[i]; });

  const FloorPlane plane = floor_plane(camera, expected.sway_a);
  const std::vector<PlaneMotion> candidates = decompose(homography->b_from_a);
  double motion = 0.0;
  for (const PlaneMotion& candidate : candidates) motion = std::max(motion, candidate.translation_in_heights.norm());
  if (motion < c.decompose_from_heights) return {};
  const Decomposed chosen = choose(candidates, plane.normal_in_camera, {c.normal_angle_rad, c.along_normal_heights});
  return chosen.motion ? std::string_view{} : "normal_refused";
}

/// The fit's covariance is that of keyframe_from_robot; consecutive ones share most of it. Each step carries its
/// share of a keyframe's life, and the scale's uncertainty such that it adds up linearly over `scale_memory_m`.
Eigen::Matrix3d step_covariance(const FloorConfig& c, const Eigen::Matrix3d& fitted, const Pose2& moved) {
  const double length = moved.translation().norm();
  const double life =
      std::clamp(std::max(length / c.keyframe_m, std::abs(moved.heading) / c.keyframe_rad), 0.02, 1.0);
  Eigen::Matrix3d covariance = 2.0 * life * fitted;
  const double scale = c.scale_sigma * c.scale_sigma * c.scale_memory_m * length;
  covariance(0, 0) += scale;
  covariance(1, 1) += scale;
  covariance(2, 2) += 1e-4 * scale;
  return 0.5 * (covariance + covariance.transpose());
}

}  // namespace

std::optional<MountReport> Floor::mount(const Odometry& odometry) const {
  return odometry.mount.has_value() ? odometry.mount->report() : std::nullopt;
}

Step Floor::observe(Odometry& s, const View* view, const Motion& motion) const {
  const Step reckoned = dead_reckon(config_.blind, motion, {});
  const Pose2 moved = planar(reckoned.previous_from_current);
  s.ended.reset();
  roll(motion, s.wheels);
  if (view == nullptr) return blind(s, reckoned, "dropped_frame");
  const auto* image = std::get_if<Image>(&view->data);
  if (image == nullptr) return blind(s, reckoned, "not_an_image");
  if (!is_whole(*image) || image->width != camera_.width || image->height != camera_.height)
    return blind(s, reckoned, "wrong_size");

  const TrackingImage now = prepare_tracking(*image, config_.window_px, config_.pyramid_levels);
  const bool first = !s.newest;
  if (first) forget_sway(config_, s);
  if (!s.rocking) s.rocking.emplace(camera_.robot_from_camera.translation.z());
  PlanarState expected{s.keyframe_from_robot * moved, s.keyframe_sway, s.sway};
  Followed followed;
  PlanarFit fit;
  const auto try_to_see = [&]() -> std::string_view {
    if (first) return "first_view";
    if (s.keyframe_tracks < static_cast<std::size_t>(config_.fewest_tracks)) return "low_contrast";
    followed = follow(camera_, config_, s, now, expected);
    if (const std::string_view refused = refused_by_homography(camera_, config_, expected, followed);
        !refused.empty())
      return refused;
    fit = fit_planar_motion(camera_, camera_, followed.pairs, sway_prior(config_, s), expected);
    if (!fit.converged) return "not_converged";
    const Pose2 seen = s.keyframe_from_robot.inverse() * fit.state.a_from_b;
    const MotionGate gate{config_.wheels_share, config_.wheels_m, config_.wheels_rad, config_.command_factor};
    if (!agrees(gate, motion, moved, seen)) return motion.wheels ? "disagrees_with_wheels" : "disagrees_with_command";
    return {};
  };
  const std::string_view refused = try_to_see();
  s.newest = now;
  s.frame = view->frame;
  if (!refused.empty()) {
    Step step = blind(s, reckoned, refused);
    s.inliers = 0;
    begin_keyframe_unseen(config_, camera_, s);
    return step;
  }

  const Sway change = Sway::from(fit.state.sway_b.vector() - s.sway.vector());
  const Pose2 as_if_from_floor = s.keyframe_from_robot.inverse() * fit.state.a_from_b;
  const bool follows_a_view = s.inliers > 0;
  if (follows_a_view) s.rocking->learn(as_if_from_floor, change, motion);
  const Pose2 seen = follows_a_view ? s.rocking->corrected(as_if_from_floor, change) : as_if_from_floor;
  Step step{Metric2{seen, step_covariance(config_, fit.covariance.topLeftCorner<3, 3>(), seen)}, true, {}};
  s.keyframe_from_robot = fit.state.a_from_b;
  s.sway = fit.state.sway_b;
  s.sway_covariance = fit.covariance.bottomRightCorner<3, 3>();
  retain(followed, [&](std::size_t i) { return fit.residual_px[i] < 2.0 * config_.homography_px; });
  s.tracks = std::move(followed.tracks);
  s.inliers = s.tracks.size();
  const bool worn =
      static_cast<double>(s.tracks.size()) < config_.keyframe_share * static_cast<double>(s.keyframe_tracks);
  if (worn || s.keyframe_from_robot.translation().norm() > config_.keyframe_m ||
      std::abs(s.keyframe_from_robot.heading) > config_.keyframe_rad) {
    s.ended = views_of(config_, camera_, s);
    if (!s.mount.has_value()) s.mount.emplace(camera_, mount_prior(config_));
    s.mount->add(*s.ended);
    begin_keyframe(config_, camera_, s);
  }
  return step;
}

}  // namespace weft::agents
