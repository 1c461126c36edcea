#pragma once
#include <string_view>

#include "agents/navigation/navigator.hpp"
#include "core/ids.hpp"

namespace weft::agents {

/// Watches whether the route lies elsewhere than where the robot believes that it stands, and counts how often a
/// goal's route was given back for that.
class StrayPolicy {
 public:
  /// Takes what the navigator says of the route at a sample.
  void look(Following following, std::string_view reason);
  void reset() { strays_ = false; }
  bool strays() const { return strays_; }
  /// Returns whether the goal's route is to be given back: a few times for a goal; then it fails, and says why.
  bool gives_back(const GoalId& goal);

 private:
  bool strays_ = false;
  GoalId given_back_;  ///< the goal whose route was given back last
  int times_ = 0;      ///< for that goal
};

}  // namespace weft::agents
