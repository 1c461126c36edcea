#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "agents/bodies/body.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

struct SimBodyConfig {
  Site site;
  std::string robot;       ///< one of the site's
  std::uint64_t seed = 1;  ///< same seed, robot and day, same calls: the same samples, bit for bit
  std::uint64_t day = 0;   ///< another day: other calibration errors, light and noise on the same floor
  std::optional<std::string> floors_dir;  ///< photographs instead of a procedural floor
  std::optional<std::string> truth_path;  ///< a JSON line per frame is appended: robot, frame, t, x, y, heading
  std::function<void(const std::string&)> warn;  ///< optional; assumptions that were made
};

/// kind() is "sim". not_found: no such robot, folder; invalid, corrupt: a photograph or sidecar, by name;
/// unavailable: the truth file cannot be written.
Result<std::unique_ptr<Body>> make_sim_body(const SimBodyConfig& config);

}  // namespace weft::agents::sim
