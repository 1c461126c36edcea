#pragma once
#include <cstdint>
#include <filesystem>
#include <map>

#include "core/geometry/pose2.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Tells where a simulated robot was at one frame.
struct TrueMoment {
  double true_s = 0.0;  ///< of the simulation's clock
  Pose2 site_from_robot;
};

/// Reads one robot's truth file (docs/simulation.md), by frame. unavailable: cannot be read; corrupt: names the line.
Result<std::map<std::uint64_t, TrueMoment>> read_truth(const std::filesystem::path& file);

}  // namespace weft::evaluate
