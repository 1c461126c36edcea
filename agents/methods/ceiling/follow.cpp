#include "agents/methods/ceiling/follow.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "agents/methods/ceiling/gauge.hpp"
#include "agents/methods/ceiling/off_image.hpp"
#include "agents/methods/ceiling/own_noise.hpp"
#include "agents/perception/attitude.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/lens_slope.hpp"
#include "agents/perception/plane/consensus.hpp"

namespace weft::agents {
namespace {

/// Returns the tracks that are found in the newest view, and their pairs at no height yet; the best windows first.
Followed found_again(const CameraModel& camera, const CeilingConfig& c, const Ceiling::Odometry& s,
                     const TrackingImage& image, const PlanarState& expected, const HeightPrior& prior) {
  std::vector<Eigen::Vector2d> from;
  std::vector<Eigen::Vector2d> guess;
  const Reprojector reproject_expected(camera, camera, expected);
  for (const Ceiling::Tracked& t : s.tracks) {
    from.push_back(t.pixel);
    const std::optional<Height> height = height_of(prior, t.told);
    const Reprojection there = reproject_expected(t.in_keyframe, height ? height->above_floor_m : prior.ceiling_m);
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
    Ceiling::Tracked track = s.tracks[i];
    track.pixel = found[i].pixel;
    track.tells = {};
    out.tracks.push_back(track);
    const Eigen::Vector2d in_b = normalised_from_pixel(camera, track.pixel);
    out.pairs.push_back(
        {track.in_keyframe, in_b, c.track_sigma_px, track.counts * pixels_by_normalised(camera, in_b)});
  }
  return out;
}

/// Keeps the pairs for which `keep` holds, in both lists. Returns whether any was dropped.
template <class Keep>
bool retain(Followed& followed, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < followed.pairs.size(); ++i) {
    if (!keep(i)) continue;
    followed.pairs[kept] = followed.pairs[i];
    followed.tracks[kept++] = followed.tracks[i];
  }
  const bool has_dropped = kept < followed.pairs.size();
  followed.pairs.resize(kept);
  followed.tracks.resize(kept);
  return has_dropped;
}

/// Sets the height of each pair as it is known before this motion is; drops what is no part of a ceiling.
void set_known_heights(const FollowedHeights& heights, Followed& followed) {
  retain(followed, [&](std::size_t i) {
    const std::optional<Height> height = height_of(heights.prior, followed.tracks[i].told);
    if (!height) return false;
    followed.pairs[i].above_floor_m = heights.one_plane ? heights.prior.ceiling_m : height->above_floor_m;
    followed.pairs[i].above_floor_sigma_m = heights.one_plane ? 0.0 : height->sigma_m;
    return true;
  });
}

/// Puts points of a view on level planes, robot frame.
class OnLevel {
 public:
  OnLevel(const CameraModel& camera, const Attitude& attitude) {
    const Pose3 level_from_camera = level_from_body(attitude) * camera.robot_from_camera;
    turned_ = level_from_camera.rotation.toRotationMatrix();
    eye_ = level_from_camera.translation;
  }
  Eigen::Vector2d operator()(const Eigen::Vector2d& in_view, double above_floor_m) const {
    const Eigen::Vector3d ray = turned_ * in_view.homogeneous();
    return eye_.head<2>() + (above_floor_m - eye_.z()) / ray.z() * ray.head<2>();
  }

 private:
  Eigen::Matrix3d turned_;
  Eigen::Vector3d eye_;
};

/// Returns the pairs that one rigid motion explains (Lucas et al., II.C, by two points in place of a homography):
/// points of the level plane, within what a view's own tilt and the points' heights may put them aside.
std::vector<bool> on_one_motion(const CameraModel& camera, const CeilingConfig& c, const FollowedHeights& heights,
                                const PlanarState& expected, const std::vector<PlanePair>& pairs) {
  const double away_m = heights.prior.ceiling_m - camera.robot_from_camera.translation.z();
  std::vector<Eigen::Vector2d> at_a;
  std::vector<Eigen::Vector2d> at_b;
  std::vector<Match> matches;
  const OnLevel level_a(camera, expected.attitude_a);
  const OnLevel level_b(camera, expected.attitude_b);
  for (const PlanePair& pair : pairs) {
    const auto i = static_cast<std::uint32_t>(at_a.size());
    at_a.push_back(level_a(pair.in_a, pair.above_floor_m));
    at_b.push_back(level_b(pair.in_b, pair.above_floor_m));
    matches.push_back({i, i, 0});
  }
  // A height that is wrong by a share moves a point by that share of the travel; a tilt does as much.
  constexpr double wrong_share = 0.4;
  const double aside_m = wrong_share * expected.a_from_b.translation().norm() + 4.0 * c.vibration_tilt_rad * away_m;
  const double within_px = 2.0 * c.inlier_px;
  const Consensus consensus = find_consensus({.within_m = within_px * away_m / focal_px(camera) + aside_m,
                                              .hypotheses = 100,
                                              .shortest_base_m = 0.1 * away_m,
                                              .score = ConsensusScore::truncated},
                                             matches, at_a, at_b);
  // The farther out, the less a pixel tells of the plane: whether a point agrees is asked in the image.
  const double f = focal_px(camera);
  const Reprojector reproject(camera, camera, {consensus.a_from_b, expected.attitude_a, expected.attitude_b});
  std::vector<bool> on(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Reprojection there = reproject(pairs[i]);
    if (!there.in_front) continue;
    const Eigen::Matrix2d px_by_normalised = f * pixels_by_normalised(camera, there.in_b);
    const double px_per_m = (px_by_normalised * there.jacobian.leftCols<2>()).norm() / std::sqrt(2.0);
    const Eigen::Vector2d off_px =
        pixel_from_normalised(camera, pairs[i].in_b) - pixel_from_normalised(camera, there.in_b);
    on[i] = off_px.norm() < within_px + px_per_m * aside_m;
  }
  return on;
}

/// Sets each pair's height by what a motion has left along its epipolar direction: a corner that seems to be of the
/// ceiling is taken for one, which holds the motion's scale; one that hangs lends it none, as long as no keyframe
/// before has told its height.
void set_told_heights(const CameraModel& camera, const FollowedHeights& heights, Followed& followed) {
  const HeightTeller teller(camera, followed.fit, heights.prior);
  retain(followed, [&](std::size_t i) {
    PlanePair& pair = followed.pairs[i];
    Ceiling::Tracked& track = followed.tracks[i];
    track.tells = teller.told_by(pair);
    const ToldHeight all = together(track.told, track.tells);
    const std::optional<Height> height = height_of(heights.prior, all);
    if (!height) return false;
    const bool on_ceiling = likely_on_ceiling(heights.prior, all) > 0.5;
    if (on_ceiling) {
      pair.above_floor_m = heights.prior.ceiling_m;
      pair.above_floor_sigma_m = heights.prior.flat_sigma_m;
    } else if (track.told.information > 0.0) {
      const std::optional<Height> before = height_of(heights.prior, track.told);
      pair.above_floor_m = before ? before->above_floor_m : height->above_floor_m;
      pair.above_floor_sigma_m = before ? before->sigma_m : heights.prior.hangs_sigma_m;
    } else {
      pair.above_floor_m = height->above_floor_m;
      pair.above_floor_sigma_m = heights.prior.hangs_sigma_m;
    }
    return true;
  });
}

/// Returns whether keyframes have told enough heights to hold the scale.
bool is_scale_held(const Followed& followed) {
  constexpr std::ptrdiff_t enough = 12;
  return std::count_if(followed.tracks.begin(), followed.tracks.end(),
                       [](const Ceiling::Tracked& track) { return track.told.information > 0.0; }) >= enough;
}

/// Returns how well wheels know a motion's length, metres, 1 sigma: the robot's rocking is none of theirs.
double wheels_sigma_m(const CeilingConfig& c, double away_m, double travel_m) {
  return std::hypot(c.wheels_scale * travel_m, c.vibration_tilt_rad * away_m);
}

/// Returns by how much wheels have moved since the keyframe, metres; none: they are silent, or the ceiling's height
/// is only supposed, until they tell it.
std::optional<double> moved_by_wheels(const CeilingConfig& c, const Ceiling::Odometry& s) {
  const bool is_scaled = c.height_m > 0.0 || s.scale_by_wheels;
  if (!s.wheels || !is_scaled) return std::nullopt;
  return s.wheels->translation().norm();
}

/// Brings motion and told heights to the scale in which the ceiling is where it is known to be and nothing is above
/// it. What keyframes have told holds it unless much says that it is wrong, as where the first corners hung.
void set_gauge(const CameraModel& camera, const CeilingConfig& c, const FollowedHeights& heights,
               const Ceiling::Odometry& s, Followed& followed) {
  const double camera_m = camera.robot_from_camera.translation.z();
  Pose2& a_from_b = followed.fit.state.a_from_b;
  const double travel_m = a_from_b.translation().norm();
  KnownScale known;
  known.is_held = is_scale_held(followed);
  if (const std::optional<double> by_wheels_m = moved_by_wheels(c, s); by_wheels_m && *by_wheels_m > 0.0) {
    known.factor = *by_wheels_m / travel_m;
    known.sigma_share = wheels_sigma_m(c, heights.prior.ceiling_m - camera_m, travel_m) / travel_m;
  }
  const HeightTeller teller(camera, followed.fit, heights.prior);
  std::vector<ToldHeight> tell;
  for (const PlanePair& pair : followed.pairs) tell.push_back(teller.told_by(pair));
  const double factor = gauge_factor(tell, heights.prior, camera_m, known);
  if (factor == 1.0) return;
  a_from_b.x *= factor;
  a_from_b.y *= factor;
  for (Ceiling::Tracked& track : followed.tracks) track.told = scaled(track.told, factor, camera_m);
}

/// Says how well a motion's scale is known before keyframes have told heights; before the motion itself tells any, as
/// what is seen hangs anywhere, its length is mostly what wheels say of it.
void admit_scale(const CameraModel& camera, const CeilingConfig& c, const FollowedHeights& heights,
                 const Ceiling::Odometry& s, bool tells, Followed& followed) {
  Pose2& a_from_b = followed.fit.state.a_from_b;
  const double travel_m = a_from_b.translation().norm();
  if (!(travel_m > 0.0) || is_scale_held(followed)) return;
  const double away_m = heights.prior.ceiling_m - camera.robot_from_camera.translation.z();
  double sigma_m = travel_m * (tells ? c.wheels_scale : c.hangs_sigma_m / away_m);
  const Eigen::Vector2d along = Eigen::Rotation2Dd(-a_from_b.heading) * a_from_b.translation() / travel_m;
  if (const std::optional<double> by_wheels_m = moved_by_wheels(c, s); !tells && by_wheels_m) {
    const double wheels_m = wheels_sigma_m(c, away_m, *by_wheels_m);
    const double share = sigma_m * sigma_m / (sigma_m * sigma_m + wheels_m * wheels_m);
    const double longer = 1.0 + share * (*by_wheels_m / travel_m - 1.0);
    a_from_b.x *= longer;
    a_from_b.y *= longer;
    sigma_m *= std::sqrt(1.0 - share);
  }
  followed.fit.covariance.topLeftCorner<2, 2>() += sigma_m * sigma_m * along * along.transpose();
}

/// Keeps what the motion explains, whatever its height. Returns whether anything was dropped.
bool retain_agreeing(const CameraModel& camera, const CeilingConfig& c, const FollowedHeights& heights,
                     Followed& followed) {
  const OffImage off(camera, followed.fit.state);
  return retain(followed, [&](std::size_t i) {
    const PlanePair& pair = followed.pairs[i];
    if (heights.one_plane || pair.above_floor_sigma_m == 0.0) return off.px(pair) < 2.0 * c.inlier_px;
    return off.across_px(pair) < c.inlier_px;
  });
}

}  // namespace

Followed follow_corners(const CameraModel& camera, const CeilingConfig& c, const Ceiling::Odometry& s,
                        const TrackingImage& image, const FollowedHeights& heights, const AttitudePrior& prior,
                        const PlanarState& expected) {
  const auto fewest = static_cast<std::size_t>(c.fewest_tracks);
  Followed out;
  if (s.keyframe_tracks < fewest) {
    out.refused = "low_contrast";
    return out;
  }
  out = found_again(camera, c, s, image, expected, heights.prior);
  const std::size_t found = out.pairs.size();
  const auto are_too_few = [&] {
    const bool few = out.pairs.size() < fewest ||
                     static_cast<double>(out.pairs.size()) < c.fewest_tracks_share * static_cast<double>(found);
    if (few) out.refused = "few_tracks";
    return few;
  };
  set_known_heights(heights, out);
  if (are_too_few()) return out;
  if (!heights.one_plane) {
    const std::vector<bool> on = on_one_motion(camera, c, heights, expected, out.pairs);
    retain(out, [&](std::size_t i) { return on[i]; });
    if (are_too_few()) return out;
  }
  out.fit = fit_with_own_noise(camera, out.pairs, c.track_sigma_px, prior, expected);
  bool has_dropped = retain_agreeing(camera, c, heights, out);
  if (are_too_few()) return out;
  const double travel_m = out.fit.state.a_from_b.translation().norm();
  const bool tells = !heights.one_plane && travel_m >= c.height_from_m;
  constexpr int rounds = 2;
  for (int round = 0; round < rounds && (tells || round == 0); ++round) {
    // The fit is that of these very pairs where none was dropped.
    if (has_dropped || !out.fit.converged)
      out.fit = fit_with_own_noise(camera, out.pairs, c.track_sigma_px, prior, out.fit.state);
    if (!tells) break;
    set_gauge(camera, c, heights, s, out);
    set_told_heights(camera, heights, out);
    if (are_too_few()) return out;
    out.fit = fit_with_own_noise(camera, out.pairs, c.track_sigma_px, prior, out.fit.state);
    has_dropped = retain_agreeing(camera, c, heights, out);
    if (are_too_few()) return out;
  }
  if (!heights.one_plane) admit_scale(camera, c, heights, s, tells, out);
  if (!out.fit.converged) out.refused = "not_converged";
  return out;
}

}  // namespace weft::agents
