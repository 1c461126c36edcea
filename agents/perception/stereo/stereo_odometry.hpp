#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "agents/perception/stereo/stereo_keyframe.hpp"
#include "core/network/relation.hpp"

namespace weft::agents {

/// Describes what a view shows of the robot's motion since the one before.
struct SeenMotion {
  Metric3 previous_from_current;  ///< robot frames
  std::size_t inliers = 0;
  double residual_px = 0.0;
  bool is_keyframe = false;  ///< it is the one that those after it are compared with
  bool makes_up = false;     ///< the view before was blind: the step also takes back what was wrongly assumed then
};

/// Sees a robot's motion in space by a pair: corners of a keyframe, whose depths both cameras tell, are followed in
/// the left images after it. The right image is looked at when a view becomes the keyframe. Pure: all that it
/// remembers is in its State.
class StereoOdometry {
 public:
  /// Holds what is remembered from view to view.
  struct State {
    std::optional<StereoKeyframe> keyframe;
    std::optional<StereoKeyframe> spare;  ///< of a view that did not fit the keyframe
    std::optional<Vector6d> camera_rate;  ///< twist a second, of the last step that was seen
    std::size_t misfits = 0;              ///< views in a row that did not fit
  };
  /// Answers whether the robot could have moved so from the last view that was seen to this one. `assumed`: how it
  /// was assumed to have moved from there to the view before this one.
  using IsPossible = std::function<bool(const Pose3& seen, const Pose3& assumed)>;

  /// invalid: `config` or the sensor breaks a bound.
  static Result<StereoOdometry> make(const StereoOdometryConfig& config, const Sensor& sensor);

  const Rectifier& rectifier() const { return rectifier_; }

  /// Compares a view with the keyframe. `elapsed`: since the view before. Refuses "wrong_size", "too_dark",
  /// "covered", "first_view", "low_contrast" (no corners), "few_inliers", "crowded" (they cover too little of the
  /// image), "blurred" (they are too far off), "impossible" (`is_possible` says no). A view that is refused is blind:
  /// `assume` tells how the robot moved meanwhile.
  /// The keyframe outlives views that do not fit it, and the first one that does makes up for what was assumed. A
  /// view that fits only the one before it, which did not fit, is seen from that one, which becomes the keyframe; so
  /// does the newest after `patience` views. What lies before it then stays as it was assumed.
  OrUnseen<SeenMotion> observe(State& state, const StereoPair& pair, Duration elapsed,
                               const IsPossible& is_possible) const;

  /// Tells how the robot moved in `elapsed` up to the view that was refused last, or was missing.
  void assume(State& state, const Metric3& previous_from_current, Duration elapsed) const;

 private:
  /// Holds the view that is looked at; what only some views need is prepared when it is needed.
  class View;

  StereoOdometry(const StereoOdometryConfig& config, Rectifier rectifier);

  OrUnseen<SeenMotion> refused_view(State& state, View& view, const Unseen& why) const;
  /// Returns the motion by one keyframe, and brings that up to date; untouched where the view is refused.
  OrUnseen<SeenMotion> seen_from(StereoKeyframe& keyframe, View& view, std::optional<Vector6d>& camera_rate,
                                 const IsPossible& is_possible) const;
  OrUnseen<ComparedView> compared(const StereoKeyframe& keyframe, const View& view,
                                  const std::optional<Vector6d>& camera_rate) const;
  std::optional<StereoKeyframe> keyframe_of(View& view, std::size_t fewest) const;
  bool is_worn(const StereoKeyframe& keyframe, const ComparedView& compared) const;
  Pose3 robot_step_of(const Pose3& camera_step) const;

  StereoOdometryConfig config_;
  Rectifier rectifier_;
  Pose3 camera_from_robot_;
};

}  // namespace weft::agents
