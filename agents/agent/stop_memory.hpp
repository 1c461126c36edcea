#pragma once
#include <optional>
#include <string>

#include "core/time.hpp"
#include "storage/spool.hpp"

namespace weft::agents {

/// Keeps on the robot's own disk that it stands until a person lets it go on, so that it does not go on by itself
/// when its agent is started again.
class StopMemory {
 public:
  explicit StopMemory(storage::Spool& spool) : spool_(&spool) {}

  /// Returns what was kept last.
  storage::Stops kept() const { return spool_->stops(); }
  /// Keeps them where they differ from that; what fails is tried again, each second. Returns what there is to log:
  /// the first failure of each time, and what follows from it; empty: nothing.
  std::string keep(const storage::Stops& stops, SteadyTime now);

 private:
  storage::Spool* spool_;
  std::optional<SteadyTime> failed_at_;
};

}  // namespace weft::agents
