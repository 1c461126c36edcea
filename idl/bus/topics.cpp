#include "idl/bus/topics.hpp"

namespace weft::bus {
namespace {

using std::chrono::seconds;
constexpr Roles kServer = msg::Role::server;
constexpr Roles kAgent = msg::Role::agent;
constexpr Roles kClient = msg::Role::client;
constexpr Roles kPeers = kAgent | kClient;
constexpr std::uint32_t kKiB = 1024;
constexpr std::uint32_t kMiB = 1024 * kKiB;
/// Bounds a chunk's message in bytes: its data and the fields around it.
constexpr std::uint32_t kChunkMessage = static_cast<std::uint32_t>(msg::kChunkBytes) + kKiB;

constexpr std::array<Topic, kTopics> kTable = {{
#define WEFT_TOPIC(Id, Name, ...) {.id = TopicId::Id, .type = "weft::idl::" #Name, __VA_ARGS__},
#include "idl/bus/message_list.hpp"
}};

}  // namespace

std::span<const Topic, kTopics> topics() {
  return kTable;
}

const Topic& topic(TopicId id) {
  return kTable[static_cast<std::size_t>(id)];
}

Result<void> check_publish(const Topic& topic, msg::Role role, const PeerId& to, ByteView cdr) {
  constexpr std::size_t kEncapsulation = 4;
  constexpr std::size_t kKey = 16;
  const std::string name(topic.name);
  if (!topic.writers.has(role)) return fail(ErrorCode::invalid, name + " is not written by this role");
  if (topic.addressed && !to) return fail(ErrorCode::invalid, name + " needs an addressee and has none");
  if (cdr.size() < kEncapsulation + (topic.keyed ? kKey : 0)) {
    return fail(ErrorCode::invalid, name + ": " + std::to_string(cdr.size()) + " bytes are no message");
  }
  if (cdr.size() > topic.max_bytes) {
    return fail(ErrorCode::invalid, name + ": a message of " + std::to_string(cdr.size()) +
                                        " bytes is larger than the topic's " + std::to_string(topic.max_bytes));
  }
  return {};
}

}  // namespace weft::bus
