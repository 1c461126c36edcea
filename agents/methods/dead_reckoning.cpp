#include "agents/methods/dead_reckoning.hpp"

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
  step.a_from_b = exp2({distance_m, 0.0, turn_rad});
  step.covariance.diagonal() << sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad;
  return {step, false, reason};
}

}  // namespace weft::agents
