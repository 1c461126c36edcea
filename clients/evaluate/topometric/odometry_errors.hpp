#pragma once
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "clients/evaluate/topometric/moment.hpp"

/// Judges the odometry of a drive by its truth. All pure.
namespace weft::evaluate::topometric {

/// Returns how far a chain of odometry is off the truth at each moment, both begun at the first one; metres.
std::vector<double> chain_errors_m(const Moments& moments, Pose2 Moment::*chain);

/// Tells how a drive was followed.
struct FollowedSteps {
  double samples = 0.0;  ///< after the first view, while the robot moved or was told to
  double blind = 0.0;    ///< of these, not seen
  double wrong = 0.0;    ///< called seen, and off by more than 20 mm or 2 degrees
  double largest_wrong_m = 0.0;
};
/// A step that is seen after blind ones may take back what was assumed in them: it is also compared with the truth
/// since the last one that was seen, and the smaller error counts.
FollowedSteps followed_steps(const Moments& moments);

/// Returns whether what the robot's cameras show at that moment is not the site: dark or covered, one lens or both.
bool is_hidden(const agents::sim::Site& site, const Moment& moment);
/// Returns how many moments with `fix` or `kept` set there were in such a blackout.
double fixes_while_hidden(const agents::sim::Site& site, const Moments& moments);
double kept_while_hidden(const agents::sim::Site& site, const Moments& moments);

/// Returns the metres truly driven up to each moment.
std::vector<double> metres_driven(const Moments& moments);
/// Returns all metres driven; 0 without moments.
double metres_in(const Moments& moments);

}  // namespace weft::evaluate::topometric
