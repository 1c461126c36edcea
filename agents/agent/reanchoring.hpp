#pragma once
#include <optional>
#include <string>

#include "agents/agent/replica.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Keeps the robot's estimate in the map. The place that it refers to can leave the window: an edit has taken it out
/// of the map, or the window is of another part by now. Which of the two, and what beside it is left, shows when
/// exactly what was around that place is asked for.
class Reanchoring {
 public:
  struct Step {
    WindowDefinition definition;  ///< to ask for
    bool is_over = false;         ///< the definition is the usual one again, but for what is always held
    std::string note;             ///< for the log; empty: nothing
  };
  /// Goes on after a change of the window. None: there is nothing to ask for.
  std::optional<Step> on_change(const Replica& replica, Navigator& navigator);
  /// Ends without a result: the window is of another part on purpose, or places are not in the map yet.
  void reset() { before_.reset(); }
  bool is_under_way() const { return before_.has_value(); }

 private:
  std::optional<Step> begin(const Replica& replica, const std::optional<Estimate>& estimate);

  std::optional<Window> before_;  ///< the window that had the place
};

}  // namespace weft::agents
