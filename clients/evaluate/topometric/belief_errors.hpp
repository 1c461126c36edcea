#pragma once
#include <vector>

#include "clients/evaluate/topometric/moment.hpp"

/// Judges what a robot has believed of where it was. All pure.
namespace weft::evaluate::topometric {

/// Holds how far off it was, sample by sample.
struct BeliefErrors {
  std::vector<double> metres;
  std::vector<double> radians;
};
/// Compares what is believed with the truth, relative to where the place it is believed at was truly taught; while it
/// is not lost. Places that are not in `places` are left out.
BeliefErrors belief_errors(const Moments& moments, const TruePlaces& places);

/// Holds how well fixes state their own uncertainty.
struct FixErrors {
  double held_percent;  ///< whose 95 % ellipse holds the truth (chi square, 3 degrees of freedom); NaN of none
  double mean_nees;     ///< normalised error squared: 3 where covariances are right; NaN of none
};
FixErrors fix_errors(const Moments& moments, const TruePlaces& places);

/// Tells how the changes from chart to chart went.
struct SwitchErrors {
  std::vector<double> jumps_m;
  std::vector<double> stands_s;  ///< that it stood within a second before and after each, on its way
};
SwitchErrors switch_errors(const Moments& moments);

/// Returns whether the robot is where it believes to be, within so much.
bool is_believed_right(const BelievedAt& believed, const Pose2& site_from_robot, const TruePlaces& places,
                       double metres, double radians);

}  // namespace weft::evaluate::topometric
