#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/protocol/query_messages.hpp"

namespace weft::cli {

/// Reads on through the server's events, each once, and notices when some are missing.
class EventCursor {
 public:
  /// Begins behind an event's number; 0: before the first.
  explicit EventCursor(std::uint64_t after = 0) : after_(after) {}

  /// Returns the number behind which to ask.
  std::uint64_t after() const { return after_; }

  struct Taken {
    std::vector<msg::Event> events;  ///< not shown before, oldest first
    std::string lost;                ///< what cannot be shown any more, and why; empty: nothing
    bool is_all = true;              ///< false: there are more behind them, ask at once
  };
  /// Takes the answer on what is behind `after`, of which the server gives `most` at once.
  Taken take(msg::QueryReply reply, std::size_t most);

 private:
  std::uint64_t after_;
};

}  // namespace weft::cli
