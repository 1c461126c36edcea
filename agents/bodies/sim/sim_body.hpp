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
  std::optional<std::string> hall_dir;    ///< photographs of what stands in the hall (hall/hall_photographs.hpp)
  std::optional<std::string>
      truth_path;  ///< a JSON line per frame is appended: robot, frame, t, x, y, heading, touch
  std::function<void(const std::string&)> warn;  ///< optional; assumptions that were made
};

/// Adds to a body what the simulation does with it; the agent that drives it knows a Body.
class SimulatedBody : public Body {
 public:
  /// Lifts the robot and puts it down there, rolling with `moving`; nobody leads it any more, and the light is
  /// another one, as when a lead begins.
  virtual void put(const Pose2& site_from_robot, const Twist& moving) = 0;
  /// Returns the true pose at the newest sample, for judges.
  virtual Pose2 site_from_robot() const = 0;
};

/// Makes a simulated body; its kind() is "sim". not_found: no such robot, folder; invalid, corrupt: a photograph or
/// sidecar, by name; unavailable: the truth file cannot be opened.
Result<std::unique_ptr<SimulatedBody>> make_sim_body(const SimBodyConfig& config);

}  // namespace weft::agents::sim
