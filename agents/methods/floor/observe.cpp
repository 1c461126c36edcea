#include <algorithm>
#include <cmath>

#include "agents/methods/floor/fallback.hpp"
#include "agents/methods/floor/floor.hpp"
#include "agents/methods/floor/plane_bounds.hpp"
#include "agents/methods/plane_odometry.hpp"
#include "agents/perception/keyframe_account.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/plane/one_plane.hpp"

namespace weft::agents {
namespace {

/// Makes the newest view the keyframe.
void begin_keyframe(const FloorConfig& c, const CameraModel& camera, const Image& view, Floor::Odometry& s) {
  s.keyframe_view = view;
  s.keyframe_attitude = s.attitude;
  s.keyframe_from_robot = Pose2{};
  s.keyframe_covariance.setZero();
  s.wheels = Pose2{};
  s.tracks.clear();
  CornerConfig corners;
  corners.count = c.corners;
  corners.border_px = c.window_px / 2 + 3;
  const std::vector<Eigen::Vector2d> found = find_corners(s.newest, corners);
  const std::vector<Eigen::Matrix2d> counts = counts_at(s.newest, found, c.grey_noise);
  for (std::size_t i = 0; i < found.size(); ++i)
    s.tracks.push_back({normalised_from_pixel(camera, found[i]), found[i], counts[i]});
  s.keyframe_tracks = s.tracks.size();
}

/// Returns what the keyframe and the newest view show of the mount.
PlaneViews views_of(const FloorConfig& c, const CameraModel& camera, const Floor::Odometry& s) {
  PlaneViews views{{}, s.keyframe_from_robot, s.wheels};
  for (const Floor::Tracked& t : s.tracks)
    views.points.push_back({t.in_keyframe, normalised_from_pixel(camera, t.pixel), c.track_sigma_px, t.counts});
  return views;
}

MountPrior mount_prior(const FloorConfig& c) {
  MountPrior prior;
  prior.tilt_rad = 3.0 * c.mount_tilt_rad;  // mounts get knocked
  prior.vibration_tilt_rad = c.vibration_tilt_rad;
  prior.vibration_height_m = c.vibration_height_m;
  return prior;
}

struct Followed {
  std::vector<Floor::Tracked> tracks;  ///< ordered by how well the window fits
  std::vector<PlanePair> pairs;
};

Followed follow(const CameraModel& camera, const FloorConfig& c, const Floor::Odometry& s, const TrackingImage& image,
                const PlanarState& expected) {
  std::vector<Eigen::Vector2d> from;
  std::vector<Eigen::Vector2d> guess;
  const Reprojector reproject_expected(camera, camera, expected);
  for (const Floor::Tracked& t : s.tracks) {
    from.push_back(t.pixel);
    const Reprojection there = reproject_expected(t.in_keyframe);
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
    out.tracks.push_back({s.tracks[i].in_keyframe, found[i].pixel, s.tracks[i].counts});
    out.pairs.push_back({s.tracks[i].in_keyframe, normalised_from_pixel(camera, found[i].pixel), c.track_sigma_px,
                         s.tracks[i].counts});
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

/// Returns a blind step and begins a keyframe.
Step lose_sight(const FloorConfig& c, const CameraModel& camera, const Image& view, Floor::Odometry& s,
                const Step& reckoned, std::string_view reason) {
  Step step = out_of_sight(s, reckoned, reason);
  begin_keyframe(c, camera, view, s);
  return step;
}

/// Keeps the corners that fit; begins a keyframe when they are few or the last one is far.
void go_on(const FloorConfig& c, const CameraModel& camera, const Image& view, Floor::Odometry& s, Followed followed,
           const PlanarFit& fit) {
  const bool has_corners = s.seen_by == Floor::SeenBy::corners;
  if (has_corners) {
    retain(followed, [&](std::size_t i) { return fit.residual_px[i] < 2.0 * c.homography_px; });
    s.tracks = std::move(followed.tracks);
    s.inliers = s.tracks.size();
  }
  const bool worn = !has_corners ||
                    static_cast<double>(s.tracks.size()) < c.keyframe_share * static_cast<double>(s.keyframe_tracks);
  if (!worn && s.keyframe_from_robot.translation().norm() <= c.keyframe_m &&
      std::abs(s.keyframe_from_robot.heading) <= c.keyframe_rad)
    return;
  if (has_corners) s.ended = views_of(c, camera, s);
  tell_keyframe(c, s);
  if (s.ended) s.mount->add(*s.ended);
  begin_keyframe(c, camera, view, s);
}

}  // namespace

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
  if (!s.mount) s.mount.emplace(camera_, mount_prior(config_));
  if (!s.rocking_centre) s.rocking_centre.emplace(camera_.robot_from_camera.translation.z());
  const PlanarState expected{s.keyframe_from_robot * moved, s.keyframe_attitude, s.attitude};
  Followed followed;
  PlanarFit fit;
  const auto is_possible = [&]() {
    const Pose2 seen = s.keyframe_from_robot.inverse() * fit.state.a_from_b;
    return agrees({config_.wheels_share, config_.wheels_m, config_.wheels_rad, config_.command_factor}, motion, moved,
                  seen);
  };
  const auto follow_corners = [&]() -> std::string_view {
    if (s.keyframe_tracks < static_cast<std::size_t>(config_.fewest_tracks)) return "low_contrast";
    followed = follow(camera_, config_, s, now, expected);
    const OnePlane plane =
        one_plane(camera_, one_plane_bounds(config_), expected, followed.pairs, config_.homography_px);
    if (!plane.refused.empty()) return plane.refused;
    retain(followed, [&](std::size_t i) { return plane.is_on_it[i]; });
    fit = fit_planar_motion(camera_, camera_, followed.pairs, view_prior(config_, s), expected);
    return fit.converged ? "" : "not_converged";
  };
  const auto take = [&](std::optional<SeenOtherwise> otherwise) {
    if (!otherwise) return false;
    fit = std::move(otherwise->fit);
    s.inliers = otherwise->points;
    return is_possible();
  };
  std::string_view refused = first ? "first_view" : follow_corners();
  s.seen_by = SeenBy::corners;
  if (refused.empty() && !is_possible()) {
    refused = motion.wheels ? "disagrees_with_wheels" : "disagrees_with_command";
    s.seen_by = SeenBy::nothing;
  } else if (!refused.empty()) {
    const AttitudePrior prior = view_prior(config_, s);
    s.seen_by = SeenBy::nothing;
    if (!first && take(see_directly(camera_, s.keyframe_view, *image, prior, expected))) {
      s.seen_by = SeenBy::grey_values;
    } else if (!first &&
               take(see_by_features(camera_, birds_eye_, config_, s.keyframe_view, *image, prior, expected))) {
      s.seen_by = SeenBy::features;
    }
  }
  ++s.views_by[static_cast<std::size_t>(s.seen_by)];
  const bool follows_a_view = s.followed;
  s.newest = now;
  s.frame = view->frame;
  s.followed = s.seen_by != SeenBy::nothing;
  if (!s.followed) return lose_sight(config_, camera_, *image, s, reckoned, refused);

  const Attitude change = Attitude::from(fit.state.attitude_b.vector() - s.attitude.vector());
  const Pose2 as_if_from_floor = s.keyframe_from_robot.inverse() * fit.state.a_from_b;
  if (follows_a_view) s.rocking_centre->learn(as_if_from_floor, change, motion);
  const Pose2 seen = follows_a_view ? s.rocking_centre->corrected(as_if_from_floor, change) : as_if_from_floor;
  const PlanarErrors common = calibration_errors_.of(seen, s.mount->tilt().found);
  Step step{Metric2{seen, step_covariance(fit, seen, common, s)}, true, {}, in_space(common)};
  s.keyframe_from_robot = fit.state.a_from_b;
  s.attitude = fit.state.attitude_b;
  s.attitude_covariance = fit.covariance.bottomRightCorner<3, 3>();
  go_on(config_, camera_, *image, s, std::move(followed), fit);
  return step;
}

}  // namespace weft::agents
