#pragma once
#include <deque>
#include <optional>
#include <string>

#include "agents/bodies/sim/site.hpp"
#include "agents/bodies/sim/solids.hpp"
#include "agents/perception/motion.hpp"
#include "core/geometry/pose2.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// Describes the errors of one robot's own wheels as its base reports them: reported / rolled.
struct WheelErrors {
  double left_scale = 1.0;
  double right_scale = 1.0;
};
/// Draws scale error and asymmetry of at least the stated sizes, at most a fifth more, and signs, from `random`.
WheelErrors wheel_errors_from(const Disturbances& disturbances, Random random);

/// Simulates a differential drive: delayed commands, inertia, limits, slip. Pure: the same calls give the same
/// motion.
class Base {
 public:
  Base(const BaseSetup& setup, const Disturbances& disturbances, const Solids& solids, const WheelErrors& wheels,
       const Pose2& site_from_robot, Random random);

  /// Stands there from now on, or rolls there with `moving` already, which is in force.
  void put(const Pose2& site_from_robot, const Twist& moving);
  /// Drives with `command` for `duration_s`, integrated in steps of at most 5 ms.
  void advance(const Twist& command, double duration_s);

  const Pose2& site_from_robot() const { return site_from_robot_; }
  /// Returns what there is to run into, as it stands now.
  const Solids& solids() const { return solids_; }
  /// Returns the name of what it has touched since the last call, the first if there was more; none: nothing.
  std::optional<std::string> take_touch();
  /// Returns the true motion now; zero against what stands in its way.
  Twist velocity() const { return velocity_; }
  /// Returns whether nothing rolls and nothing that was commanded waits.
  bool at_rest() const;
  /// Returns what the wheels have reported since the last call.
  WheelStep take_wheel_step();

 private:
  void substep(const Twist& command, double dt_s);
  void roll_to(const Pose2& next);

  struct Delayed {
    double due_s = 0.0;
    Twist command;
  };
  BaseSetup setup_;
  double slip_sigma_ = 0.0;
  Solids solids_;
  WheelErrors wheels_;
  Pose2 site_from_robot_;
  Random random_;
  double now_s_ = 0.0;
  std::deque<Delayed> waiting_;
  Twist in_force_;
  double left_m_s_ = 0.0, right_m_s_ = 0.0;    ///< rims
  double left_slip_ = 0.0, right_slip_ = 0.0;  ///< share of the rim's way that is lost
  Twist velocity_;
  WheelStep reported_;
  std::optional<std::string> touch_;
};

/// Returns the distance from a point (site frame) to the rim of a rectangle about a pose, metres; negative inside.
double distance_to_rim(const Pose2& site_from_middle, double length_m, double width_m, double x, double y);
/// Returns the distance from a point (site frame) to a box's footprint, metres; 0 inside.
double distance_to(const Box& box, double x, double y);

}  // namespace weft::agents::sim
