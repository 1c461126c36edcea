#include "agents/methods/dead_reckoning.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {

Step dead_reckon(const DeadReckoningConfig& config, const Motion& motion, std::string_view reason) {
  const double elapsed_s = seconds(motion.elapsed);
  const double distance_m = motion.wheels ? motion.wheels->distance_m : motion.command.linear_m_s * elapsed_s;
  const double turn_rad = motion.wheels ? motion.wheels->heading_rad : motion.command.angular_rad_s * elapsed_s;
  const double distance_share = motion.wheels ? config.wheel_distance_share : config.command_distance_share;
  const double heading_share = motion.wheels ? config.wheel_heading_share : config.command_heading_share;
  const double sigma_m = distance_share * std::abs(distance_m);
  const double sigma_rad = heading_share * (std::abs(turn_rad) + std::abs(distance_m));
  Metric2 step;
  step.a_from_b = se2_exp({distance_m, 0.0, turn_rad});
  step.covariance.diagonal() << sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad;
  return {step, false, reason};
}

bool agrees(const MotionGate& gate, const Motion& motion, const Pose2& expected, const Pose2& seen) {
  const double loose = motion.wheels ? 1.0 : gate.command_factor;
  const Pose2 off = expected.inverse() * seen;
  const double distance = std::max(expected.translation().norm(), seen.translation().norm());
  const double turn = std::max(std::abs(expected.heading), std::abs(seen.heading));
  return off.translation().norm() < loose * (gate.metres + gate.share * distance) &&
         std::abs(off.heading) < loose * (gate.radians + gate.share * turn);
}

}  // namespace weft::agents
