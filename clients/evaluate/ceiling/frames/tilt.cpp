#include "clients/evaluate/ceiling/frames/tilt.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/lens_slope.hpp"
#include "agents/perception/mount.hpp"
#include "agents/perception/planar_motion.hpp"
#include "agents/perception/plane/consensus.hpp"

namespace weft::evaluate::ceiling {
namespace {

using namespace agents;

constexpr double kRadADegree = std::numbers::pi / 180.0;
constexpr double kWidestRad = 0.9;     // off the axis: so far out a camera that leans still sees the ceiling
constexpr double kLowestShare = 0.15;  // of the height that a ray climbs over its length: what is lower is no ceiling
constexpr int kWindowPx = 13;
constexpr int kLevels = 3;
constexpr std::size_t kFewestCorners = 12;

/// Holds corners from where they were found first to where they are now.
struct Following {
  std::vector<Eigen::Vector2d> first_px;
  std::vector<Eigen::Vector2d> now_px;
};

bool is_near_axis(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  return std::atan(normalised_from_pixel(camera, pixel).norm()) < kWidestRad;
}

Following begin(const CameraModel& camera, const TrackingImage& image) {
  CornerConfig config;
  config.detector = CornerDetector::harris;
  config.count = 200;
  config.border_px = kWindowPx / 2 + 3;
  Following following;
  for (const Eigen::Vector2d& corner : find_corners(image, config))
    if (is_near_axis(camera, corner)) following.first_px.push_back(corner);
  following.now_px = following.first_px;
  return following;
}

/// Follows corners on; keeps those that lead back to where they came from.
void follow(const TrackingImage& from, const TrackingImage& to, Following& following) {
  constexpr double back_px = 0.7;
  const std::vector<Track> tracks = track_corners(from, to, following.now_px, following.now_px);
  std::vector<Eigen::Vector2d> there;
  for (const Track& track : tracks) there.push_back(track.pixel);
  const std::vector<Track> back = track_corners(to, from, there, there);
  Following still;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (!tracks[i].found || !back[i].found) continue;
    if ((back[i].pixel - following.now_px[i]).norm() > back_px) continue;
    still.first_px.push_back(following.first_px[i]);
    still.now_px.push_back(tracks[i].pixel);
  }
  following = std::move(still);
}

double median_moved_px(const Following& following) {
  std::vector<double> moved;
  for (std::size_t i = 0; i < following.now_px.size(); ++i)
    moved.push_back((following.now_px[i] - following.first_px[i]).norm());
  if (moved.empty()) return 0.0;
  const auto middle = moved.begin() + static_cast<std::ptrdiff_t>(moved.size() / 2);
  std::nth_element(moved.begin(), middle, moved.end());
  return *middle;
}

SeenTwice seen_in(const CameraModel& camera, const Following& following) {
  SeenTwice seen;
  for (std::size_t i = 0; i < following.now_px.size(); ++i) {
    if (!is_near_axis(camera, following.now_px[i])) continue;
    seen.in_a.push_back(normalised_from_pixel(camera, following.first_px[i]));
    seen.in_b.push_back(normalised_from_pixel(camera, following.now_px[i]));
  }
  return seen;
}

/// Returns a view's corner on the level ceiling; none: the ray hardly climbs.
std::optional<Eigen::Vector2d> on_ceiling(const Eigen::Matrix3d& level_from_camera, double away_m,
                                          const Eigen::Vector2d& in_view) {
  const Eigen::Vector3d ray = level_from_camera * in_view.homogeneous();
  if (ray.z() < kLowestShare * ray.norm()) return std::nullopt;
  return Eigen::Vector2d(away_m * ray.head<2>() / ray.z());
}

/// Holds the rigid motion that explains a pair of views best.
struct Explained {
  Pose2 a_from_b;
  std::vector<double> residual_px;  ///< of the corners that a level ceiling can hold
};

/// Explains a pair of views by one rigid motion. None: few corners are those of a level ceiling.
std::optional<Explained> explain(const CameraModel& camera, const SeenTwice& seen, double away_m) {
  const Eigen::Matrix3d level_from_camera = camera.robot_from_camera.rotation.toRotationMatrix();
  std::vector<Eigen::Vector2d> at_a;
  std::vector<Eigen::Vector2d> at_b;
  std::vector<Match> matches;
  std::vector<PlanePair> pairs;
  for (std::size_t i = 0; i < seen.in_a.size(); ++i) {
    const auto a = on_ceiling(level_from_camera, away_m, seen.in_a[i]);
    const auto b = on_ceiling(level_from_camera, away_m, seen.in_b[i]);
    if (!a || !b) continue;
    const auto index = static_cast<std::uint32_t>(at_a.size());
    at_a.push_back(*a);
    at_b.push_back(*b);
    matches.push_back({index, index, 0});
    PlanePair pair{seen.in_a[i], seen.in_b[i]};
    pair.counts = pixels_by_normalised(camera, pair.in_b);
    pair.above_floor_m = camera.robot_from_camera.translation.z() + away_m;
    pairs.push_back(pair);
  }
  if (matches.size() < kFewestCorners) return std::nullopt;
  const Consensus consensus = find_consensus({.within_m = 2.0 * kMostLeftPx * away_m / focal_px(camera),
                                              .hypotheses = 60,
                                              .shortest_base_m = 0.3 * away_m,
                                              .score = ConsensusScore::truncated},
                                             matches, at_a, at_b);
  AttitudePrior level;  // the tilt is the mount's: none is left for the views
  level.information.diagonal().setConstant(1e12);
  const PlanarFit fit = fit_planar_motion(camera, camera, pairs, level, {consensus.a_from_b, {}, {}});
  Explained explained{fit.state.a_from_b, {}};
  const Reprojector reproject(camera, camera, fit.state);
  for (const PlanePair& pair : pairs) {
    const Reprojection there = reproject(pair);
    const double off_px = pair.in_sigmas(focal_px(camera) * (pair.in_b - there.in_b)).norm();
    explained.residual_px.push_back(there.in_front ? off_px : kMostLeftPx);
  }
  return explained;
}

/// Returns the sum of what the best rigid motion leaves of a pair of views, pixels.
double left_of(const CameraModel& camera, const SeenTwice& seen, double away_m) {
  const std::optional<Explained> explained = explain(camera, seen, away_m);
  const std::size_t on_ceiling = explained ? explained->residual_px.size() : 0;
  double left = kMostLeftPx * static_cast<double>(seen.in_a.size() - on_ceiling);
  if (explained)
    for (const double residual : explained->residual_px) left += std::min(residual, kMostLeftPx);
  return left;
}

}  // namespace

std::vector<SeenTwice> seen_twice(const CameraModel& camera, const std::vector<Image>& frames, double apart_rad) {
  std::vector<SeenTwice> pairs;
  TrackingImage before;
  Following following;
  for (const Image& frame : frames) {
    const TrackingImage now = prepare_tracking(frame, kWindowPx, kLevels);
    if (before) follow(before, now, following);
    const bool is_worn = following.now_px.size() < kFewestCorners;
    const bool has_moved = median_moved_px(following) > apart_rad * focal_px(camera);
    if (has_moved && !is_worn) {
      SeenTwice seen = seen_in(camera, following);
      if (seen.in_a.size() >= kFewestCorners) pairs.push_back(std::move(seen));
    }
    if (has_moved || is_worn) following = begin(camera, now);
    before = now;
  }
  return pairs;
}

double left_px(const CameraModel& camera, const std::vector<SeenTwice>& pairs, double away_m) {
  double left = 0.0;
  double corners = 0.0;
  for (const SeenTwice& seen : pairs) {
    left += left_of(camera, seen, away_m);
    corners += static_cast<double>(seen.in_a.size());
  }
  return corners > 0.0 ? left / corners : kMostLeftPx;
}

std::optional<FoundTilt> find_tilt(const CameraModel& camera, const std::vector<SeenTwice>& pairs, double away_m) {
  constexpr std::size_t fewest_pairs = 3;
  constexpr double widest = 40.0 * kRadADegree;
  constexpr double coarse = 4.0 * kRadADegree;
  constexpr double fine = 0.05 * kRadADegree;
  if (pairs.size() < fewest_pairs) return std::nullopt;
  const auto tried = [&](double pitch_rad, double roll_rad) {
    return FoundTilt{pitch_rad, roll_rad, left_px(tilted(camera, pitch_rad, roll_rad), pairs, away_m)};
  };
  FoundTilt best = tried(0.0, 0.0);
  const auto take = [&](const FoundTilt& one) {
    const bool is_better = one.left_px < best.left_px;
    if (is_better) best = one;
    return is_better;
  };
  for (double pitch = -widest; pitch <= widest + 1e-9; pitch += coarse)
    for (double roll = -widest; roll <= widest + 1e-9; roll += coarse) take(tried(pitch, roll));
  for (double step = 0.5 * coarse; step > fine;) {
    const FoundTilt middle = best;
    bool is_better = false;
    for (const auto& [p, r] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)})
      is_better = take(tried(middle.pitch_rad + p * step, middle.roll_rad + r * step)) || is_better;
    if (!is_better) step *= 0.5;
  }
  return best;
}

Eigen::Vector2d travelled(const CameraModel& camera, const std::vector<SeenTwice>& pairs, double away_m) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const SeenTwice& seen : pairs)
    if (const std::optional<Explained> explained = explain(camera, seen, away_m))
      sum += explained->a_from_b.translation();
  return sum;
}

}  // namespace weft::evaluate::ceiling
