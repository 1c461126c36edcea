#pragma once
#include "clients/evaluate/registration/trials.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct RegisterRoomsOptions {
  Seeds seeds{1, 20};
  agents::NdtConfig config{};
};

namespace registration {

/// Sums up the trials of one kind of scene.
struct EdgeSummary {
  std::size_t edges = 0;
  std::size_t refused = 0;
  double along_ratio = 0.0;  ///< median error after by median before
  double across_ratio = 0.0;
  double heading_ratio = 0.0;
  double grown_share = 0.0;  ///< whose error grew by more than 1 cm
  double mean_nees = 0.0;    ///< 6 where covariances are right
};
EdgeSummary summary_of(const std::vector<Trial>& trials);

/// Registers places of simulated rooms and aisles: edges of a run with the odometry's prior (row E1 of the method
/// topometric: never worse than its prior), and stitches between two runs from a vague guess. Prints a table each,
/// the bounds of E1 and whether they hold. Complete, or missed, or stopped.
Result<Ended> study_rooms(const RegisterRoomsOptions& options, const Surroundings& around);

}  // namespace registration
}  // namespace weft::evaluate
