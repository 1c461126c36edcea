#pragma once
#include "agents/methods/method.hpp"

namespace weft::agents {

/// Sets the error of wheels and commands while vision is blind: one sigma, as a share of what was moved.
struct DeadReckoningConfig {
  double wheel_distance_share = 0.05;    ///< of the distance, along and across; (0, 1]
  double wheel_heading_share = 0.05;     ///< of the turn, and rad per metre driven; (0, 1]
  double command_distance_share = 0.15;  ///< the same where the body has no wheels to read
  double command_heading_share = 0.15;
};

/// Returns the step that every method falls back to: the wheels' increment where the body has them, else the command
/// in force, integrated as an arc (constant velocity, Gadd & Newman III-C). Always blind; `reason` is static text.
Step dead_reckon(const DeadReckoningConfig& config, const Motion& motion, std::string_view reason);

/// Bounds how far vision may differ from wheels or command before it is taken for wrong: this finds gross errors
/// only, as wheels slip and are some per cent off.
struct MotionGate {
  double share = 0.35;          ///< of the motion; (0, 2]
  double metres = 0.04;         ///< plus this; (0, 1]
  double radians = 0.06;        ///< plus this; (0, 1]
  double command_factor = 3.0;  ///< looser by this where only the command is known; [1, 20]
};

/// Returns whether the motion `seen` is one that wheels or command, which say `expected`, could have made.
bool agrees(const MotionGate& gate, const Motion& motion, const Pose2& expected, const Pose2& seen);

}  // namespace weft::agents
