#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/methods/ceiling/fallback.hpp"
#include "agents/methods/ceiling/follow.hpp"
#include "agents/methods/ceiling/known_mount.hpp"
#include "agents/methods/ceiling/rectified.hpp"
#include "agents/methods/image_of.hpp"
#include "agents/methods/plane_odometry.hpp"
#include "agents/perception/direct_alignment.hpp"
#include "agents/perception/keyframe_account.hpp"
#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

/// Returns whether a pixel shows what the lens is known for and what is overhead: near the horizon lamps run into one
/// another, and a pixel of error is half a ceiling's height.
bool may_be_followed(const CeilingConfig& c, const CameraModel& camera, const Eigen::Vector2d& pixel) {
  const Eigen::Vector3d in_camera = normalised_from_pixel(camera, pixel).homogeneous().normalized();
  return in_camera.z() > std::cos(c.off_axis_rad) &&
         (camera.robot_from_camera.rotation * in_camera).z() > std::cos(c.off_vertical_rad);
}

/// Fills the tracks up with new corners where none is followed yet: what is followed keeps its height.
void add_corners(const CeilingConfig& c, const CameraModel& camera, const Image& view, Ceiling::Odometry& s) {
  constexpr double apart_px = 8.0;
  CornerConfig corners;
  corners.detector = c.detector;
  corners.count = c.corners;
  corners.border_px = c.window_px / 2 + 3;
  const Lamps lamps(view, lamp_config(c));
  for (const Eigen::Vector2d& corner : find_corners(s.newest, corners)) {
    if (s.tracks.size() >= static_cast<std::size_t>(c.corners)) break;
    if (!lamps.counts(corner) || !may_be_followed(c, camera, corner)) continue;
    const bool is_new = std::none_of(s.tracks.begin(), s.tracks.end(), [&](const Ceiling::Tracked& t) {
      return (t.pixel - corner).squaredNorm() < apart_px * apart_px;
    });
    if (is_new) s.tracks.push_back({normalised_from_pixel(camera, corner), corner});
  }
}

/// Makes the newest view the keyframe; the corners that are still followed are begun with.
void begin_keyframe(const CeilingConfig& c, const CameraModel& camera, const Image& view, Ceiling::Odometry& s) {
  s.keyframe_view = view;
  s.keyframe_attitude = s.attitude;
  s.keyframe_from_robot = Pose2{};
  s.keyframe_covariance.setZero();
  s.wheels = Pose2{};
  const int half_window_px = c.window_px / 2;
  const double border = half_window_px + 2.0;
  std::erase_if(s.tracks, [&](const Ceiling::Tracked& t) {
    return t.pixel.x() < border || t.pixel.y() < border || t.pixel.x() > camera.width - 1.0 - border ||
           t.pixel.y() > camera.height - 1.0 - border || !may_be_followed(c, camera, t.pixel);
  });
  for (Ceiling::Tracked& t : s.tracks) {
    t.told = together(t.told, t.tells);
    t.tells = {};
    t.in_keyframe = normalised_from_pixel(camera, t.pixel);
  }
  add_corners(c, camera, view, s);
  std::vector<Eigen::Vector2d> pixels;
  for (const Ceiling::Tracked& t : s.tracks) pixels.push_back(t.pixel);
  const std::vector<Eigen::Matrix2d> counts = counts_at(s.newest, pixels, c.grey_noise);
  for (std::size_t i = 0; i < counts.size(); ++i) s.tracks[i].counts = counts[i];
  s.keyframe_tracks = s.tracks.size();
}

/// Returns a blind step and begins a keyframe with new corners. The mount's tilt is still known.
Step lose_sight(const CeilingConfig& c, const CameraModel& camera, const Image& view, Ceiling::Odometry& s,
                const Step& reckoned, std::string_view reason) {
  Step step = out_of_sight(s, reckoned, reason);
  s.tracks.clear();
  begin_keyframe(c, camera, view, s);
  return step;
}

/// Holds the ceiling's height against the wheels over the keyframe that ends.
void compare_wheels(Ceiling::Odometry& s) {
  if (!s.wheels) return;
  s.wheels_m += s.wheels->translation().norm();
  s.seen_m += s.keyframe_from_robot.translation().norm();
}

/// Takes the ceiling's height from the wheels once they have turned far enough; what was told at the supposed height
/// is told anew.
void take_scale(const CeilingConfig& c, const CameraModel& camera, double supposed_m, Ceiling::Odometry& s) {
  if (c.height_m > 0.0 || s.scale_by_wheels || s.wheels_m < c.wheels_way_m || !(s.seen_m > 0.0)) return;
  const double camera_m = camera.robot_from_camera.translation.z();
  const double factor = s.wheels_m / s.seen_m;
  const double away_m = factor * (supposed_m - camera_m);
  s.scale_by_wheels = CeilingScale{camera_m + away_m, c.wheels_scale * away_m};
  for (Ceiling::Tracked& t : s.tracks) {
    t.told = scaled(t.told, factor, camera_m);
    t.tells = scaled(t.tells, factor, camera_m);
  }
  s.birds_eye.emplace(camera, rectified_area(c, camera, s.scale_by_wheels->ceiling_m));
}

bool is_worn(const CeilingConfig& c, const Ceiling::Odometry& s, double away_m) {
  return s.seen_by != Ceiling::SeenBy::corners ||
         static_cast<double>(s.tracks.size()) < c.keyframe_share * static_cast<double>(s.keyframe_tracks) ||
         s.keyframe_from_robot.translation().norm() > c.keyframe_heights * away_m ||
         std::abs(s.keyframe_from_robot.heading) > c.keyframe_rad;
}

}  // namespace

Step Ceiling::observe(Odometry& s, const View* view, const Motion& motion) const {
  const Step reckoned = dead_reckon(config_.blind, motion, {});
  const Pose2 moved = planar(reckoned.previous_from_current);
  s.ended.reset();
  roll(motion, s.wheels);
  if (view == nullptr) return blind(s, reckoned, "dropped_frame");
  const OrRefusal<const Image*> whole = image_of(*view, camera_);
  if (!whole) return blind(s, reckoned, whole.error().reason);
  const Image& image = **whole;

  const TrackingImage now = prepare_tracking(image, config_.window_px, config_.pyramid_levels);
  const bool first = !s.newest;
  const double camera_m = camera_.robot_from_camera.translation.z();
  if (!s.mount) s.mount.emplace(camera_, mount_prior(config_));
  if (!s.rocking_centre) s.rocking_centre.emplace(camera_m);
  const double ceiling_m = working_height_m(s);
  const bool is_scaled = scale(s).has_value();
  const PlanarState expected{s.keyframe_from_robot * moved, s.keyframe_attitude, s.attitude};
  const AttitudePrior prior = view_prior(config_, s);
  PlanarFit fit;
  const auto is_possible = [&] {
    // Without a scale, wheels and vision cannot be held against each other yet.
    const Pose2 seen = s.keyframe_from_robot.inverse() * fit.state.a_from_b;
    return !is_scaled || agrees({config_.wheels_share, config_.wheels_m, config_.wheels_rad, config_.command_factor},
                                motion, moved, seen);
  };
  std::string_view refused = first ? "first_view" : "";
  Followed followed;
  s.seen_by = SeenBy::nothing;
  if (!first) {
    const FollowedHeights heights{height_prior(config_, ceiling_m, camera_m),
                                  s.mount->tilt().sigma_rad() > config_.heights_tilt_rad};
    followed = follow_corners(camera_, config_, s, now, heights, prior, expected);
    refused = followed.refused;
    fit = followed.fit;
    if (refused.empty() && !is_possible()) {
      refused = motion.wheels ? "disagrees_with_wheels" : "disagrees_with_command";
    } else if (refused.empty()) {
      s.seen_by = SeenBy::corners;
    } else if (auto direct =
                   agreed_directly(camera_, s.keyframe_view, image, prior, expected, {.above_floor_m = ceiling_m})) {
      fit = std::move(direct->fit);
      s.inliers = direct->points;
      if (is_possible()) s.seen_by = SeenBy::grey_values;
    } else if (const std::optional<BirdsEye>& plane = birds_eye_ ? birds_eye_ : s.birds_eye; plane) {
      if (auto by_features = see_ceiling_by_features({camera_, s.keyframe_view, image, ceiling_m}, *plane, config_,
                                                     prior, expected)) {
        fit = std::move(by_features->fit);
        s.inliers = by_features->points;
        if (is_possible()) s.seen_by = SeenBy::features;
      }
    }
  }
  ++s.views_by[static_cast<std::size_t>(s.seen_by)];
  const bool follows_a_view = s.followed;
  s.newest = now;
  s.frame = view->frame;
  s.followed = s.seen_by != SeenBy::nothing;
  if (!s.followed) return lose_sight(config_, camera_, image, s, reckoned, refused);

  const Attitude change = Attitude::from(fit.state.attitude_b.vector() - s.attitude.vector());
  const Pose2 as_if_from_floor = s.keyframe_from_robot.inverse() * fit.state.a_from_b;
  if (follows_a_view && is_scaled) s.rocking_centre->learn(as_if_from_floor, change, motion);
  const Pose2 seen = follows_a_view ? s.rocking_centre->corrected(as_if_from_floor, change) : as_if_from_floor;
  const CeilingScale known = scale(s).value_or(CeilingScale{ceiling_m, ceiling_m});
  const PlanarErrors common = common_errors(config_, camera_, known, seen, s.mount->tilt().found);
  Step step{Metric2{seen, step_covariance(fit, seen, common, s)}, true, {}, in_space(common)};
  if (!is_scaled) step = {reckoned.previous_from_current, false, "scale_unknown"};
  s.keyframe_from_robot = fit.state.a_from_b;
  s.attitude = fit.state.attitude_b;
  s.attitude_covariance = fit.covariance.bottomRightCorner<3, 3>();
  if (s.seen_by == SeenBy::corners) {
    s.tracks = std::move(followed.tracks);
    s.inliers = s.tracks.size();
  } else {
    s.tracks.clear();
  }
  if (!is_worn(config_, s, ceiling_m - camera_m)) return step;
  if (s.seen_by == SeenBy::corners) s.ended = PlaneViews{std::move(followed.pairs), s.keyframe_from_robot, s.wheels};
  tell_keyframe(config_, s);
  if (s.ended) s.mount->add(*s.ended);
  compare_wheels(s);
  take_scale(config_, camera_, ceiling_m, s);
  begin_keyframe(config_, camera_, image, s);
  return step;
}

}  // namespace weft::agents
