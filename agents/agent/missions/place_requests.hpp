#pragma once
#include <optional>
#include <string>
#include <vector>

#include "agents/agent/replies.hpp"
#include "core/ids.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Keeps the commands that wait for the next place kept while teaching. All of them get the same place.
class PlaceRequests {
 public:
  void add(const CommandKey& key, SteadyTime now);
  bool empty() const { return keys_.empty(); }
  void answer(const PlaceId& kept, Replies& replies);
  void refuse_all(const std::string& reason, Replies& replies);
  /// Gives up 15 s after the last request.
  void tick(Replies& replies, SteadyTime now);
  std::optional<SteadyTime> next() const;
  void was_away(Duration away) { until_ += away; }

 private:
  std::vector<CommandKey> keys_;
  SteadyTime until_{};
};

}  // namespace weft::agents
