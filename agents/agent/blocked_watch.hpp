#pragma once
#include <optional>

#include "agents/navigation/navigator.hpp"
#include "agents/perception/motion.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Notices that the robot is asked to drive and does not move, by what it sees: its wheels may spin; or that it has a
/// route and stands, as its method sees something in the way.
class BlockedWatch {
 public:
  /// Takes what the robot is asked to do from now on, whether it stands for something that its method sees, and where
  /// it is; none: it does not know.
  void take(const Twist& asked, bool sees_something, const std::optional<Estimate>& estimate, SteadyTime now);
  /// Returns whether it has not moved for 2 s although it was to all the time.
  bool is_blocked() const { return is_blocked_; }

 private:
  std::optional<Estimate> stood_at_;  ///< when it moved last
  SteadyTime since_{};
  bool is_blocked_ = false;
};

}  // namespace weft::agents
