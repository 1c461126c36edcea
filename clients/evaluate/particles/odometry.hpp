#pragma once
#include <vector>

#include "agents/perception/particles/motion_sampling.hpp"
#include "clients/evaluate/particles/carmen_log.hpp"
#include "core/random.hpp"

namespace weft::evaluate::particles {

/// Says how wrong odometry is made.
struct OdometryErrors {
  double scale_bias = 0.02;       ///< of all steps and turns, of one sign a seed
  double noise = 0.05;            ///< of each step and turn, 1 sigma
  double heading_rad_m05 = 0.02;  ///< of a heading over a metre, growing with the root of the way, 1 sigma
};

/// Makes odometry of the increments between the poses of a log: as many steps as there are scans, the first one none.
std::vector<Pose2> simulated_odometry(const std::vector<LaserScan>& scans, const OdometryErrors& errors,
                                      std::uint64_t seed);

/// Returns a step of odometry with the covariance that AMCL's differential drive gives it, all four alphas the same
/// (Thrun, Burgard & Fox 2005, table 5.6): a turn, a way straight on and a turn, each with errors in proportion.
agents::UncertainMotion motion_of(const Pose2& previous_from_current, double alpha);

}  // namespace weft::evaluate::particles
