#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "core/network/goal.hpp"
#include "core/time.hpp"

namespace weft::server {

/// Decides which pending goal is looked at first: the one of the highest class, of equal ones the one that was
/// accepted first. Each two minutes of waiting count as one class, so that none waits for ever.
class Turns {
 public:
  /// Returns the pending goals in their turn, with `goals` in the order in which they were accepted. How long one has
  /// waited counts from when it was first given here.
  std::vector<const Goal*> in_turn(const std::vector<const Goal*>& goals, SteadyTime now);

 private:
  std::map<GoalId, SteadyTime> waits_since_;
};

}  // namespace weft::server
