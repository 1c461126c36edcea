#include "agents/perception/stereo/stereo_odometry.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "agents/perception/robust.hpp"

namespace weft::agents {
namespace {

Matrix6d positive_part_of(const Matrix6d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Matrix6d> parts(0.5 * (matrix + matrix.transpose()));
  return parts.eigenvectors() * parts.eigenvalues().cwiseMax(0.0).asDiagonal() * parts.eigenvectors().transpose();
}

/// Returns the covariance of a_from_b * b_from_c of which only the first is uncertain.
Matrix6d carried_over(const Matrix6d& of_a_from_b, const Pose3& b_from_c) {
  const Matrix6d transport = adjoint(b_from_c.inverse());
  return transport * of_a_from_b * transport.transpose();
}

/// Returns the root of the area that points cover, of the image's.
double spread_of(const std::vector<SeenPoint>& points, const std::vector<bool>& is_inlier, const StereoRig& rig) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  double count = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_inlier[i]) continue;
    const Eigen::Vector2d at(points[i].at_b.x() / rig.width, points[i].at_b.y() / rig.height);
    sum += at;
    squares += at * at.transpose();
    count += 1.0;
  }
  const Eigen::Vector2d mean = sum / count;
  const Eigen::Matrix2d covariance = squares / count - mean * mean.transpose();
  return std::sqrt(std::sqrt(std::max(0.0, covariance.determinant())));
}

CornerConfig corner_config(const StereoOdometryConfig& config) {
  CornerConfig corners;
  corners.count = config.corners;
  corners.border_px = config.window_px / 2 + 2;
  return corners;
}

/// Follows the keyframe's corners into a view, and leaves those that were found in `corners`.
std::vector<SeenPoint> followed(const Rectifier& rectifier, const TrackingImage& keyframe, const TrackingImage& now,
                                std::vector<StereoCorner>& corners, const Pose3& camera_from_keyframe) {
  const StereoRig& rig = rectifier.rig();
  std::vector<Eigen::Vector2d> from;
  std::vector<Eigen::Vector2d> expected;
  for (const StereoCorner& corner : corners) {
    from.push_back(corner.taken);
    const Eigen::Vector3d in_camera = camera_from_keyframe * corner.in_camera;
    const bool is_ahead = in_camera.z() > 0.1;
    const Eigen::Vector2d rectified(rig.focal_px * in_camera.x() / in_camera.z() + rig.cx,
                                    rig.focal_px * in_camera.y() / in_camera.z() + rig.cy);
    const bool is_within = is_ahead && rectified.x() > 0.0 && rectified.y() > 0.0 && rectified.x() < rig.width &&
                           rectified.y() < rig.height;
    expected.push_back(is_within ? rectifier.taken_left(rectified) : corner.taken);
  }
  const std::vector<Track> tracks = track_corners(keyframe, now, from, expected);
  std::vector<SeenPoint> points;
  std::vector<StereoCorner> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!tracks[i].found) continue;
    points.push_back({corners[i].in_camera, corners[i].disparity_px, rectifier.rectified_left(tracks[i].pixel)});
    kept.push_back(corners[i]);
  }
  corners = std::move(kept);
  return points;
}

}  // namespace

Result<void> check(const StereoOdometryConfig& c) {
  const auto wrong = [](const std::string& what) { return fail(ErrorCode::invalid, "stereo odometry: " + what); };
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  if (!within(c.corners, 40, 2000)) return wrong("corners is not within 40..2000");
  if (!within(c.window_px, 7, 31) || c.window_px % 2 == 0) return wrong("window_px is no odd number within 7..31");
  if (!within(c.pyramid_levels, 1, 5)) return wrong("pyramid_levels is not within 1..5");
  if (!within(c.nearest_m, 0.05, 10.0)) return wrong("nearest_m is not within 0.05..10");
  if (!within(static_cast<double>(c.fewest_inliers), 6, 1000)) return wrong("fewest_inliers is not within 6..1000");
  if (!within(c.fewest_inliers_share, 0.0, 1.0)) return wrong("fewest_inliers_share is not within 0..1");
  if (!within(c.least_spread, 0.0, 0.3)) return wrong("least_spread is not within 0..0.3");
  if (!within(c.most_residual_px, 0.1, 10.0)) return wrong("most_residual_px is not within 0.1..10");
  if (!within(c.keyframe_share, 0.1, 0.95)) return wrong("keyframe_share is not within 0.1..0.95");
  if (!within(c.keyframe_rad, 0.01, 2.0)) return wrong("keyframe_rad is not within 0.01..2");
  if (!within(c.keyframe_nearer, 0.01, 1.0)) return wrong("keyframe_nearer is not within 0.01..1");
  return {};
}

StereoOdometry::StereoOdometry(const StereoOdometryConfig& config, Rectifier rectifier)
    : config_(config), rectifier_(std::move(rectifier)) {
  constexpr double most_of_width = 0.2;
  const StereoRig& rig = rectifier_.rig();
  config_.corner.most_px = std::min(rig.disparity_px(config.nearest_m), most_of_width * rig.width);
  camera_from_robot_ = rectifier_.rig().robot_from_camera.inverse();
}

Result<StereoOdometry> StereoOdometry::make(const StereoOdometryConfig& config, const Sensor& sensor) {
  if (const Result<void> sound = check(config); !sound) return fail(sound.error());
  Result<Rectifier> rectifier = Rectifier::make(sensor);
  if (!rectifier) return fail(rectifier.error());
  return StereoOdometry(config, std::move(*rectifier));
}

Pose3 StereoOdometry::camera_step_of(const Pose3& robot_step) const {
  return camera_from_robot_ * robot_step * rectifier_.rig().robot_from_camera;
}

bool StereoOdometry::begin_keyframe(State& state, const TrackingImage& left, const Image& right,
                                    std::size_t fewest) const {
  const TrackingImage other = prepare_tracking(right, config_.window_px, config_.pyramid_levels);
  std::vector<StereoCorner> corners =
      in_both(rectifier_, left, other, find_corners(left, corner_config(config_)), config_.corner);
  if (corners.size() < fewest) return false;
  state.keyframe = left;
  state.keyframe_corners = corners.size();
  state.corners = std::move(corners);
  state.keyframe_from_camera = {};
  state.keyframe_covariance.setZero();
  return true;
}

OrUnseen<PoseFit> StereoOdometry::compared(State& state, const TrackingImage& left, Duration elapsed) const {
  const auto refuse = [](std::string_view reason, double measured, double bound) {
    return tl::unexpected(Unseen{reason, measured, bound});
  };
  Pose3 expected = state.keyframe_from_camera;
  if (state.camera_rate) expected = expected * se3_exp(seconds(elapsed) * *state.camera_rate);
  std::vector<StereoCorner> corners = state.corners;
  const std::vector<SeenPoint> points = followed(rectifier_, state.keyframe, left, corners, expected.inverse());
  const auto fewest = static_cast<double>(config_.fewest_inliers);
  if (points.size() < config_.fewest_inliers)
    return refuse("few_inliers", static_cast<double>(points.size()), fewest);
  const PoseConsensus consensus = find_pose(rectifier_.rig(), points, config_.pose, expected.inverse());
  std::optional<PoseFit> fit = fit_pose(rectifier_.rig(), points, config_.pose, consensus.b_from_a);
  const double inliers = fit ? static_cast<double>(fit->inliers) : 0.0;
  const double wanted = std::max(fewest, config_.fewest_inliers_share * static_cast<double>(points.size()));
  if (inliers < wanted) return refuse("few_inliers", inliers, wanted);
  const double spread = spread_of(points, fit->is_inlier, rectifier_.rig());
  if (spread < config_.least_spread) return refuse("crowded", spread, config_.least_spread);
  if (fit->residual_px > config_.most_residual_px)
    return refuse("blurred", fit->residual_px, config_.most_residual_px);
  std::size_t next = 0;
  state.corners.clear();
  for (const StereoCorner& corner : corners)
    if (fit->is_inlier[next++]) state.corners.push_back(corner);
  return std::move(*fit);
}

bool StereoOdometry::is_worn(const State& state, const PoseFit& fit) const {
  if (static_cast<double>(state.corners.size()) <
      config_.keyframe_share * static_cast<double>(state.keyframe_corners))
    return true;
  if (Eigen::AngleAxisd(fit.b_from_a.rotation).angle() > config_.keyframe_rad) return true;
  std::vector<double> depths;
  for (const StereoCorner& corner : state.corners) depths.push_back(corner.in_camera.z());
  return fit.b_from_a.translation.norm() > config_.keyframe_nearer * median_of(std::move(depths));
}

OrUnseen<SeenMotion> StereoOdometry::observe(State& state, const StereoPair& pair, Duration elapsed,
                                             const IsPossible& is_possible) const {
  state.is_newest = false;
  if (!rectifier_.fits(pair))
    return tl::unexpected(
        Unseen{"wrong_size", static_cast<double>(pair.left.width), static_cast<double>(rectifier_.left().width)});
  if (const auto refused = too_little_light(config_.light, pair)) return tl::unexpected(*refused);
  const TrackingImage left = prepare_tracking(pair.left, config_.window_px, config_.pyramid_levels);
  if (!state.keyframe) {
    state.is_newest = begin_keyframe(state, left, pair.right, config_.fewest_inliers);
    if (!state.is_newest)
      return tl::unexpected(Unseen{"low_contrast", 0.0, static_cast<double>(config_.fewest_inliers)});
    return tl::unexpected(Unseen{"first_view"});
  }
  const std::size_t had = state.corners.size();
  State next = state;
  OrUnseen<PoseFit> fit = compared(next, left, elapsed);
  Pose3 robot_step;
  if (fit) {
    const Pose3 camera_step = state.keyframe_from_camera.inverse() * fit->b_from_a.inverse();
    robot_step = rectifier_.rig().robot_from_camera * camera_step * camera_from_robot_;
    if (is_possible && !is_possible(robot_step)) fit = tl::unexpected(Unseen{"impossible"});
    next.camera_rate = se3_log(camera_step) / std::max(1e-3, seconds(elapsed));
  }
  if (!fit) {
    state.camera_rate.reset();
    // The old keyframe may be out of sight for good; the new one must not have less.
    state.is_newest = begin_keyframe(state, left, pair.right, std::max(had, 2 * config_.fewest_inliers));
    return tl::unexpected(fit.error());
  }
  state = std::move(next);
  const Pose3 camera_step = state.keyframe_from_camera.inverse() * fit->b_from_a.inverse();
  const Matrix6d before = carried_over(state.keyframe_covariance, camera_step);
  const Matrix6d own = positive_part_of(fit->covariance - before);
  state.keyframe_covariance = before + own;
  state.keyframe_from_camera = fit->b_from_a.inverse();
  const Matrix6d to_robot = adjoint(rectifier_.rig().robot_from_camera);
  // Standing still is certain, but not singular.
  const Matrix6d stated = to_robot * own * to_robot.transpose() + 1e-14 * Matrix6d::Identity();
  SeenMotion seen{{robot_step, 0.5 * (stated + stated.transpose())}, fit->inliers, fit->residual_px, false};
  if (is_worn(state, *fit)) seen.is_keyframe = begin_keyframe(state, left, pair.right, config_.fewest_inliers);
  return seen;
}

void StereoOdometry::assume(State& state, const Metric3& previous_from_current) const {
  if (state.is_newest || !state.keyframe) return;
  const Pose3 camera_step = camera_step_of(previous_from_current.a_from_b);
  const Matrix6d to_camera = adjoint(camera_from_robot_);
  const Matrix6d covariance = previous_from_current.covariance;
  state.keyframe_covariance =
      carried_over(state.keyframe_covariance, camera_step) + to_camera * covariance * to_camera.transpose();
  state.keyframe_from_camera = state.keyframe_from_camera * camera_step;
}

}  // namespace weft::agents
