#include "agents/agent/commands.hpp"

namespace weft::agents {
namespace {
constexpr std::size_t kCommandsRemembered = 64;
}  // namespace

CommandLedger::Seen CommandLedger::see(const CommandKey& key) {
  for (const Entry& entry : entries_) {
    if (entry.key == key) return entry.reply.has_value() ? Seen::answered : Seen::under_way;
  }
  entries_.push_back({key, std::nullopt});
  if (entries_.size() > kCommandsRemembered) entries_.pop_front();
  return Seen::fresh;
}

const msg::AgentReply* CommandLedger::answer(const CommandKey& key) const {
  for (const Entry& entry : entries_) {
    if (entry.key == key && entry.reply.has_value()) return &*entry.reply;
  }
  return nullptr;
}

void CommandLedger::answered(const CommandKey& key, const msg::AgentReply& reply) {
  for (Entry& entry : entries_) {
    if (entry.key == key) entry.reply = reply;
  }
}

}  // namespace weft::agents
