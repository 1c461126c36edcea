#pragma once
#include <optional>

#include "agents/agent/replica.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Moves the window along with the robot.
class WindowFocus {
 public:
  /// Takes the place around which the map is needed, at most once a second. Returns whether it is another one than
  /// before.
  bool follow(const std::optional<PlaceId>& place, SteadyTime now);
  /// Returns that place as it was last taken.
  const PlaceId& place() const { return place_; }
  /// Returns the place around which contents are wanted: that one if the window has it.
  std::optional<PlaceId> in(const Replica& replica) const;

  struct Situation {
    std::uint32_t cap = 0;                ///< most places of the window
    std::optional<ExperienceId> taught;   ///< being taught
    bool is_beside = false;               ///< that run lies beside the place, and nothing joins it to that yet
    std::optional<PlaceId> durable = {};  ///< the newest place of that place's experience that the server has
  };
  /// Returns the window that fits that place; none: the present one does. While teaching, any part of the
  /// network may be met: all of it is asked for once, and kept as long as it fits.
  std::optional<WindowDefinition> recentred(const Replica& replica, const Situation& situation);

 private:
  PlaceId place_;
  SteadyTime taken_at_{};
  ExperienceId whole_asked_for_;  ///< the run for which the whole network was asked for
};

}  // namespace weft::agents
