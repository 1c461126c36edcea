#pragma once
#include <cstdint>
#include <deque>
#include <optional>

#include "core/protocol/messages.hpp"

namespace weft::agents {

/// Identifies a command: its number alone need not be unique across starts of the server.
struct CommandKey {
  Epoch epoch;
  std::uint64_t command = 0;
  bool operator==(const CommandKey&) const = default;
};

/// Sees to it that each command is done once, however often it comes: repeats get the answer that was given before.
class CommandLedger {
 public:
  enum class Seen { fresh, under_way, answered };
  /// Notes a fresh command as under way.
  Seen see(const CommandKey& key);
  /// Returns the answer that was given; null while there is none.
  const msg::AgentReply* answer(const CommandKey& key) const;
  void answered(const CommandKey& key, const msg::AgentReply& reply);

 private:
  struct Entry {
    CommandKey key;
    std::optional<msg::AgentReply> reply;
  };
  std::deque<Entry> entries_;
};

}  // namespace weft::agents
