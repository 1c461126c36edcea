#pragma once
#include <string>

#include "agents/agent/commands.hpp"
#include "agents/agent/outbox.hpp"
#include "core/protocol/messages.hpp"

namespace weft::agents {

/// Answers commands. A command that comes again gets the answer that it got before.
class Replies {
 public:
  explicit Replies(Outbox& outbox) : outbox_(outbox) {}

  /// Returns whether the command is to be carried out: it has not been seen before.
  bool is_fresh(const CommandKey& key);
  /// Sends the answer, with the number of its command.
  void give(const CommandKey& key, msg::AgentReply answer);
  void refuse(const CommandKey& key, std::string reason);

 private:
  Outbox& outbox_;
  CommandLedger ledger_;
};

/// Returns the answer that a command has been carried out.
msg::AgentReply carried_out();

}  // namespace weft::agents
