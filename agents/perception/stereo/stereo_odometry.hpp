#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "agents/perception/stereo/pair_light.hpp"
#include "agents/perception/stereo/stereo_corners.hpp"
#include "agents/perception/stereo/unseen.hpp"
#include "agents/perception/stereo/view_pose.hpp"
#include "core/network/relation.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Sets how a pair's motion is seen.
struct StereoOdometryConfig {
  int corners = 250;            ///< [40, 2000] wanted of each keyframe
  int window_px = 15;           ///< odd, [7, 31]: of the tracker
  int pyramid_levels = 3;       ///< [1, 5]
  double nearest_m = 0.5;       ///< [0.05, 10] what is nearer is not looked for
  StereoCornerBounds corner{};  ///< most_px is set by nearest_m
  PoseBounds pose{};            ///< how corners say where the view is
  // When a view counts as seen
  std::size_t fewest_inliers = 20;    ///< [6, 1000]
  double fewest_inliers_share = 0.3;  ///< [0, 1] of the corners that were found again
  double least_spread = 0.06;         ///< [0, 0.3] root of the area that inliers cover, of the image's
  double most_residual_px = 1.0;      ///< [0.1, 10] RMS of the inliers'
  PairLightBounds light{};
  // When a view becomes the keyframe
  double keyframe_share = 0.6;    ///< [0.1, 0.95] fewer of the keyframe's corners are inliers
  double keyframe_rad = 0.35;     ///< [0.01, 2] turned by more
  double keyframe_nearer = 0.15;  ///< [0.01, 1] moved by more of the corners' median depth
};
/// Rejects what breaks a bound (invalid, naming it).
Result<void> check(const StereoOdometryConfig& config);

/// Describes what a view shows of the robot's motion since the one before.
struct SeenMotion {
  Metric3 previous_from_current;  ///< robot frames
  std::size_t inliers = 0;
  double residual_px = 0.0;
  bool is_keyframe = false;  ///< it is the one that those after it are compared with
};

/// Sees a robot's motion in space by a pair: corners of a keyframe, whose depths both cameras tell, are followed in
/// the left images after it. The right image is looked at when a view becomes the keyframe. Pure: all that it
/// remembers is in its State.
class StereoOdometry {
 public:
  /// Holds what is remembered from view to view: the keyframe, and where the newest view is from there.
  struct State {
    TrackingImage keyframe;                           // left; none yet: empty
    std::vector<StereoCorner> corners;                // of the keyframe; those that fitted no view since are gone
    std::size_t keyframe_corners = 0;                 // as they began
    Pose3 keyframe_from_camera;                       // of the newest view, seen or assumed
    Matrix6d keyframe_covariance = Matrix6d::Zero();  // that steps since the keyframe have stated
    std::optional<Vector6d> camera_rate;              // twist a second, of the last step that was seen
    bool is_newest = false;                           // the newest view is the keyframe: its motion is still to come
  };
  /// Answers whether the robot could have moved so from the view before.
  using IsPossible = std::function<bool(const Pose3& previous_from_current)>;

  /// invalid: `config` or the sensor breaks a bound.
  static Result<StereoOdometry> make(const StereoOdometryConfig& config, const Sensor& sensor);

  const Rectifier& rectifier() const { return rectifier_; }

  /// Compares a view with the keyframe. `elapsed`: since the view before. Refuses "wrong_size", "too_dark",
  /// "covered", "first_view", "low_contrast" (no corners), "few_inliers", "crowded" (they cover too little of the
  /// image), "blurred" (they are too far off), "impossible" (`is_possible` says no). A view that is refused is blind:
  /// `assume` tells how the robot moved meanwhile. Where there was a keyframe and the view has corners enough that it
  /// does not share with it, the view becomes the keyframe.
  OrUnseen<SeenMotion> observe(State& state, const StereoPair& pair, Duration elapsed,
                               const IsPossible& is_possible) const;

  /// Tells how the robot moved up to the view that was refused last.
  void assume(State& state, const Metric3& previous_from_current) const;

 private:
  StereoOdometry(const StereoOdometryConfig& config, Rectifier rectifier);

  OrUnseen<PoseFit> compared(State& state, const TrackingImage& left, Duration elapsed) const;
  bool begin_keyframe(State& state, const TrackingImage& left, const Image& right, std::size_t fewest) const;
  bool is_worn(const State& state, const PoseFit& fit) const;
  Pose3 camera_step_of(const Pose3& robot_step) const;

  StereoOdometryConfig config_;
  Rectifier rectifier_;
  Pose3 camera_from_robot_;
};

}  // namespace weft::agents
