#pragma once
#include <vector>

#include "core/geometry/pose2.hpp"

namespace weft::evaluate {

/// Holds one sample of a led robot, with what was true.
struct Frame {
  Pose2 site_from_robot;   ///< the truth
  double true_s = 0.0;     ///< of the simulation's clock
  Pose2 start_from_robot;  ///< odometry
  double sensor_s = 0.0;   ///< the sample's own stamp
  bool seen = false;       ///< vision took part; otherwise wheels or commands were integrated
};

/// Holds one view of the second run, related to the nearest place of the first.
struct Attempt {
  Pose2 place_from_robot;  ///< the truth
  bool related = false;
  Pose2 measured;  ///< if related
};

/// Holds what one pair of runs came to. NaN where there was nothing to measure.
struct Score {
  double speed_error_mm_s = 0.0;  ///< RMS over half seconds while driving, by the sample's own stamps
  double drift_mm = 0.0;          ///< median over all stretches of 10 m, a new one each metre
  double drift_deg = 0.0;
  double fix_mm = 0.0;  ///< median of the fixes
  double fix_95_mm = 0.0;
  double fix_deg = 0.0;
  double fixes_percent = 0.0;  ///< of the views that a place is near of; right ones
  double wrong_fixes = 0.0;    ///< beyond 50 mm or 2 degrees
  double blind_percent = 0.0;  ///< of the samples
  bool operator==(const Score&) const = default;
};

/// Scores two runs and the attempts of the second; both runs count for odometry alike.
Score score_of(const std::vector<std::vector<Frame>>& runs, const std::vector<Attempt>& attempts);

}  // namespace weft::evaluate
