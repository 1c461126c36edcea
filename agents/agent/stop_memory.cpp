#include "agents/agent/stop_memory.hpp"

#include <utility>

namespace weft::agents {

std::string StopMemory::keep(const storage::Stops& stops, SteadyTime now) {
  constexpr Duration again = std::chrono::seconds(1);
  if (stops == kept()) {
    failed_at_.reset();
    return {};
  }
  if (failed_at_ && now - *failed_at_ < again) return {};
  const Result<void> done = spool_->keep(stops);
  if (done) {
    failed_at_.reset();
    return {};
  }
  const bool is_known = std::exchange(failed_at_, now).has_value();
  const bool stands = stops != storage::Stops{};
  const std::string follows = stands ? "if its agent is started again, the robot goes on by itself"
                                     : "if its agent is started again, the robot has to be resumed once more";
  return is_known ? ""
                  : "it is not on disk whether it may go on, until then " + follows + ": " + done.error().message;
}

}  // namespace weft::agents
