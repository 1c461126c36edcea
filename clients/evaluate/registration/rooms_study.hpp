#pragma once
#include "clients/evaluate/registration/trials.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct RegisterRoomsOptions {
  Seeds seeds{1, 20};
  agents::NdtConfig config{};
  bool json = false;  ///< one line instead of the tables
};

namespace registration {

/// Registers places of simulated rooms and aisles: edges of a run with the odometry's prior (row E1 of the method
/// topometric: never worse than its prior), and stitches between two runs from a vague guess. Prints a table each or
/// one line of JSON, with the bounds of E1 and whether they hold. Complete, or missed, or stopped.
Result<Ended> study_rooms(const RegisterRoomsOptions& options, const Surroundings& around);

}  // namespace registration
}  // namespace weft::evaluate
