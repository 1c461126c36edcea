#pragma once
#include "agents/methods/command_lag.hpp"
#include "agents/methods/dead_reckoning.hpp"
#include "agents/methods/method.hpp"
#include "agents/perception/stereo/stereo_odometry.hpp"

namespace weft::agents {

struct OpenOdometryConfig {
  StereoOdometryConfig seeing{};
  DeadReckoningConfig blind{};
  MotionGate gate{.share = 0.2};  ///< tighter than wheels ask for: looser by its factor, as only commands are known
};

/// Follows a robot by its pair, and by its commands while the pair is blind (Dayoub et al. 2013, III-C: "open"
/// odometry): commands pass through the lag that seen steps have shown. Wheels are not looked at. Seen again, it goes
/// on from the keyframe where that still matches, which takes back what was assumed.
class OpenOdometry {
 public:
  struct State {
    StereoOdometry::State seen;
    CommandLag lag;
    Image newest_left = {};  ///< of the pair before: one that comes again is no view
  };

  /// Errors of StereoOdometry::make.
  static Result<OpenOdometry> make(const OpenOdometryConfig& config, const Sensor& sensor);

  const StereoOdometry& stereo() const { return stereo_; }

  /// Returns the step since the last sample. Blind reasons are those of StereoOdometry::observe, "dropped_frame" of
  /// no view, "not_a_pair" and "frozen" of a pair that is the one before to the last bit: it would show a robot that
  /// stands; "impossible" is what commands cannot have caused.
  Step observe(State& state, const View* view, const Motion& motion) const;

 private:
  OpenOdometry(const OpenOdometryConfig& config, StereoOdometry stereo);

  OpenOdometryConfig config_;
  StereoOdometry stereo_;
};

}  // namespace weft::agents
