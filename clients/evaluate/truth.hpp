#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/geometry/pose2.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Tells where a simulated robot was at one frame.
struct TrueMoment {
  double true_s = 0.0;  ///< of the simulation's clock
  Pose2 site_from_robot;
  std::optional<std::string> touch = {};  ///< the name of what it has touched since the frame before
};

/// Reads one robot's truth file (docs/simulation.md), by frame. unavailable: cannot be read; corrupt: names the line.
Result<std::map<std::uint64_t, TrueMoment>> read_truth(const std::filesystem::path& file);

}  // namespace weft::evaluate
