#pragma once
#include <map>
#include <optional>
#include <vector>

#include "core/network/goal.hpp"
#include "core/time.hpp"

namespace weft::simulation {

/// Describes a goal that has not ended, at one moment.
struct GoalSight {
  GoalId id;
  GoalKind kind = GoalKind::operator_asked;
  std::optional<double> free_s;  ///< of driving, if nobody else were there; none: it has no route yet
  bool counts = true;  ///< nothing excuses it: its robot is there, knows where it is, and has nothing to do before it
};

/// Adds up how long goals take that nothing excuses, and tells which take too long: ten times what driving takes and
/// a quarter of an hour; of yields, three minutes.
class Progress {
 public:
  struct Late {
    GoalSight goal;
    double spent_s = 0.0;
    double most_s = 0.0;
  };

  /// Looks at all goals that have not ended. Returns those that are late, each once.
  std::vector<Late> look(SteadyTime now, const std::vector<GoalSight>& goals);

 private:
  struct Known {
    Duration spent{};
    std::optional<double> free_s;  ///< from where it was begun
    bool is_told = false;
  };

  std::optional<SteadyTime> looked_at_;
  std::map<GoalId, Known> known_;
};

}  // namespace weft::simulation
