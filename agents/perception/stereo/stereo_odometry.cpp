#include "agents/perception/stereo/stereo_odometry.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>

#include "agents/perception/robust.hpp"
#include "agents/perception/tracking_target.hpp"

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

}  // namespace

class StereoOdometry::View {
 public:
  View(const StereoOdometryConfig& config, const StereoPair& pair, Duration since_before)
      : elapsed(since_before), left(prepared(config, pair.left)), config_(config), taken_right_(pair.right) {}

  const TrackingImage& right() {
    if (!right_) right_ = prepared(config_, taken_right_);
    return right_;
  }
  /// Returns the left image as it is tracked from.
  const TrackingImage& left_with_gradients() {
    if (!left_with_gradients_) left_with_gradients_ = with_gradients(left);
    return left_with_gradients_;
  }

  const Duration elapsed;
  const TrackingImage left;

 private:
  static TrackingImage prepared(const StereoOdometryConfig& config, const Image& image) {
    return prepare_target(image, config.window_px, config.pyramid_levels);
  }

  const StereoOdometryConfig& config_;
  const Image& taken_right_;
  TrackingImage right_;
  TrackingImage left_with_gradients_;
};

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

Pose3 StereoOdometry::robot_step_of(const Pose3& camera_step) const {
  return rectifier_.rig().robot_from_camera * camera_step * camera_from_robot_;
}

std::optional<StereoKeyframe> StereoOdometry::keyframe_of(View& view, std::size_t fewest) const {
  StereoKeyframe keyframe = begin_keyframe(config_, rectifier_, view.left_with_gradients(), view.right());
  if (keyframe.corners.size() < fewest) return std::nullopt;
  return keyframe;
}

bool StereoOdometry::is_worn(const StereoKeyframe& keyframe, const ComparedView& compared) const {
  if (static_cast<double>(compared.corners.size()) <
      config_.keyframe_share * static_cast<double>(keyframe.began_with))
    return true;
  if (Eigen::AngleAxisd(compared.fit.b_from_a.rotation).angle() > config_.keyframe_rad) return true;
  std::vector<double> depths;
  for (const StereoCorner& corner : compared.corners) depths.push_back(corner.in_camera.z());
  return compared.fit.b_from_a.translation.norm() > config_.keyframe_nearer * median_of(std::move(depths));
}

OrUnseen<ComparedView> StereoOdometry::compared(const StereoKeyframe& keyframe, const View& view,
                                                const std::optional<Vector6d>& camera_rate) const {
  const auto from = [&](const Pose3& expected) {
    return compare(config_, rectifier_, keyframe, view.left, expected);
  };
  if (!camera_rate) return from(keyframe.from_camera);
  OrUnseen<ComparedView> going_on = from(keyframe.from_camera * se3_exp(seconds(view.elapsed) * *camera_rate));
  if (going_on) return going_on;
  // It may have stopped, or what was assumed may already be too much.
  OrUnseen<ComparedView> standing = from(keyframe.from_camera);
  return standing ? standing : going_on;
}

OrUnseen<SeenMotion> StereoOdometry::seen_from(StereoKeyframe& keyframe, View& view,
                                               std::optional<Vector6d>& camera_rate,
                                               const IsPossible& is_possible) const {
  OrUnseen<ComparedView> compared = this->compared(keyframe, view, camera_rate);
  if (!compared) return tl::unexpected(compared.error());
  const bool is_worn = this->is_worn(keyframe, *compared);
  const PoseFit fit = is_worn
                          ? fit_with_right(config_, rectifier_, *compared, view.left_with_gradients(), view.right())
                          : compared->fit;
  const Pose3 from_now = fit.b_from_a.inverse();
  const Pose3 since_seen = keyframe.from_seen.inverse() * from_now;
  if (is_possible &&
      !is_possible(robot_step_of(since_seen), robot_step_of(keyframe.from_seen.inverse() * keyframe.from_camera)))
    return tl::unexpected(Unseen{"impossible"});
  camera_rate = se3_log(since_seen) / std::max(1e-3, seconds(keyframe.assumed_for + view.elapsed));

  const Pose3 camera_step = keyframe.from_camera.inverse() * from_now;
  const Matrix6d before = carried_over(keyframe.covariance, camera_step);
  const Matrix6d own = positive_part_of(fit.covariance - before);
  const Matrix6d to_robot = adjoint(rectifier_.rig().robot_from_camera);
  // Standing still is certain, but not singular.
  const Matrix6d stated = to_robot * own * to_robot.transpose() + 1e-14 * Matrix6d::Identity();
  SeenMotion seen{{robot_step_of(camera_step), 0.5 * (stated + stated.transpose())},
                  fit.inliers,
                  fit.residual_px,
                  false,
                  keyframe.assumed_for > Duration{}};
  keyframe.corners = std::move(compared->corners);
  keyframe.covariance = before + own;
  keyframe.from_seen = keyframe.from_camera = from_now;
  keyframe.assumed_for = {};
  if (!is_worn) return seen;
  std::optional<StereoKeyframe> next = keyframe_of(view, config_.fewest_inliers);
  if (!next) return seen;
  keyframe = std::move(*next);
  keyframe.is_newest = false;  // how it was reached has been seen
  seen.is_keyframe = true;
  return seen;
}

OrUnseen<SeenMotion> StereoOdometry::refused_view(State& state, View& view, const Unseen& why) const {
  ++state.misfits;
  if (std::optional<StereoKeyframe> begun = keyframe_of(view, 2 * config_.fewest_inliers))
    state.spare = std::move(begun);
  if (state.spare && state.misfits > config_.patience) {
    state.keyframe = std::exchange(state.spare, std::nullopt);
    state.misfits = 0;
  }
  return tl::unexpected(why);
}

OrUnseen<SeenMotion> StereoOdometry::observe(State& state, const StereoPair& pair, Duration elapsed,
                                             const IsPossible& is_possible) const {
  for (std::optional<StereoKeyframe>* const one : {&state.keyframe, &state.spare})
    if (*one) (*one)->is_newest = false;
  if (!rectifier_.fits(pair))
    return tl::unexpected(
        Unseen{"wrong_size", static_cast<double>(pair.left.width), static_cast<double>(rectifier_.left().width)});
  if (const auto refused = too_little_light(config_.light, pair)) return tl::unexpected(*refused);
  View view(config_, pair, elapsed);
  if (!state.keyframe) {
    state.keyframe = keyframe_of(view, config_.fewest_inliers);
    if (state.keyframe) return tl::unexpected(Unseen{"first_view"});
    return tl::unexpected(Unseen{"low_contrast", 0.0, static_cast<double>(config_.fewest_inliers)});
  }
  OrUnseen<SeenMotion> seen = seen_from(*state.keyframe, view, state.camera_rate, is_possible);
  if (!seen && state.spare) {
    OrUnseen<SeenMotion> by_spare = seen_from(*state.spare, view, state.camera_rate, is_possible);
    if (by_spare) {
      state.keyframe = std::move(state.spare);
      seen = std::move(by_spare);
    }
  }
  if (!seen) return refused_view(state, view, seen.error());
  state.spare.reset();
  state.misfits = 0;
  return seen;
}

void StereoOdometry::assume(State& state, const Metric3& previous_from_current, Duration elapsed) const {
  const Pose3 camera_step = camera_from_robot_ * previous_from_current.a_from_b * rectifier_.rig().robot_from_camera;
  const Matrix6d to_camera = adjoint(camera_from_robot_);
  const Matrix6d covariance = previous_from_current.covariance;
  for (std::optional<StereoKeyframe>* const one : {&state.keyframe, &state.spare}) {
    if (!*one || std::exchange((*one)->is_newest, false)) continue;
    StereoKeyframe& keyframe = **one;
    keyframe.covariance =
        carried_over(keyframe.covariance, camera_step) + to_camera * covariance * to_camera.transpose();
    keyframe.from_camera = keyframe.from_camera * camera_step;
    keyframe.assumed_for += elapsed;
  }
}

}  // namespace weft::agents
