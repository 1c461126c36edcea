#include "agents/agent/replies.hpp"

#include <utility>

namespace weft::agents {

bool Replies::is_fresh(const CommandKey& key) {
  switch (ledger_.see(key)) {
    case CommandLedger::Seen::under_way:
      return false;
    case CommandLedger::Seen::answered:
      outbox_.send(*ledger_.answer(key));
      return false;
    case CommandLedger::Seen::fresh:
      break;
  }
  return true;
}

void Replies::give(const CommandKey& key, msg::AgentReply answer) {
  answer.command = key.command;
  ledger_.answered(key, answer);
  outbox_.send(std::move(answer));
}

void Replies::refuse(const CommandKey& key, std::string reason) {
  msg::AgentReply refusal;
  refusal.reason = std::move(reason);
  give(key, std::move(refusal));
}

msg::AgentReply carried_out() {
  msg::AgentReply done;
  done.done = true;
  return done;
}

}  // namespace weft::agents
