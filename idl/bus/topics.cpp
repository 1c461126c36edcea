#include "idl/bus/topics.hpp"

namespace weft::bus {
namespace {

using enum Delivering;
using std::chrono::seconds;
constexpr Roles kServer = msg::Role::server;
constexpr Roles kAgent = msg::Role::agent;
constexpr Roles kClient = msg::Role::client;
constexpr Roles kPeers = kAgent | kClient;
constexpr bool kKeyed = true;
constexpr bool kTo = true;  ///< addressed
constexpr bool kBulk = true;
constexpr std::uint32_t kKiB = 1024;
constexpr std::uint32_t kMiB = 1024 * kKiB;
/// A chunk's data and what stands around it.
constexpr std::uint32_t kChunkMessage = static_cast<std::uint32_t>(msg::kChunkBytes) + kKiB;

constexpr std::array<Topic, kTopics> kTable = {{
    {TopicId::hello,
     "weft/hello",
     "weft::idl::Hello",
     kKeyed,
     false,
     false,
     state,
     1,
     {},
     kServer | kPeers,
     kServer | kPeers,
     kKiB,
     "at start; then a server every 5 s, an agent every 2 to 15 s, every 0.5 s while it asks who the server is"},
    {TopicId::robot_description,
     "weft/1/robot_description",
     "weft::idl::RobotDescription",
     kKeyed,
     false,
     false,
     state,
     1,
     {},
     kAgent,
     kServer,
     512 * kKiB,
     "at start, on change"},
    {TopicId::robot_state,
     "weft/1/robot_state",
     "weft::idl::RobotState",
     kKeyed,
     false,
     false,
     state,
     1,
     {},
     kAgent,
     kServer,
     8 * kKiB,
     "up to 5/s a robot"},
    {TopicId::experience_batch,
     "weft/1/experience_batch",
     "weft::idl::ExperienceBatch",
     false,
     false,
     false,
     ordered,
     64,
     {},
     kPeers,
     kServer,
     2 * kMiB,
     "1/s a teaching robot; clients that import"},
    {TopicId::batch_ack, "weft/1/batch_ack", "weft::idl::BatchAck", false, kTo, false, prompt, 64, seconds(5),
     kServer, kPeers, 256 * kKiB, "one a batch"},
    {TopicId::chunk_up,
     "weft/1/chunk/up",
     "weft::idl::Chunk",
     false,
     false,
     kBulk,
     ordered,
     128,
     {},
     kPeers,
     kServer,
     kChunkMessage,
     "within the sender's byte budget"},
    {TopicId::chunk_down,
     "weft/1/chunk/down",
     "weft::idl::Chunk",
     false,
     kTo,
     kBulk,
     ordered,
     128,
     {},
     kServer,
     kPeers,
     kChunkMessage,
     "within the reader's byte budget"},
    {TopicId::content_request_up,
     "weft/1/content_request/up",
     "weft::idl::ContentRequest",
     false,
     false,
     false,
     prompt,
     64,
     {},
     kPeers,
     kServer,
     256 * kKiB,
     "1/s while contents are missing"},
    {TopicId::content_request_down, "weft/1/content_request/down", "weft::idl::ContentRequest", false, kTo, false,
     prompt, 64, seconds(5), kServer, kAgent, 256 * kKiB, "1/s while contents are missing"},
    {TopicId::window_request,
     "weft/1/window_request",
     "weft::idl::WindowRequest",
     false,
     false,
     false,
     prompt,
     16,
     {},
     kPeers,
     kServer,
     256 * kKiB,
     "on change, repeated until answered"},
    {TopicId::window_patch, "weft/1/window_patch", "weft::idl::WindowPatch", false, kTo, false, prompt, 64,
     seconds(5), kServer, kPeers, 2 * kMiB, "up to 2/s a reader"},
    {TopicId::recognise,
     "weft/1/recognise",
     "weft::idl::Recognise",
     false,
     false,
     false,
     prompt,
     16,
     {},
     kAgent,
     kServer,
     8 * kKiB,
     "up to 1/s a robot that looks for itself"},
    {TopicId::recognised, "weft/1/recognised", "weft::idl::Recognised", false, kTo, false, prompt, 16, seconds(5),
     kServer, kAgent, 8 * kKiB, "one a question"},
    {TopicId::route_order, "weft/1/route_order", "weft::idl::RouteOrder", false, kTo, false, prompt, 16, seconds(5),
     kServer, kAgent, 4 * kMiB, "a few a goal, repeated until answered"},
    {TopicId::route_progress,
     "weft/1/route_progress",
     "weft::idl::RouteProgress",
     false,
     false,
     false,
     prompt,
     64,
     {},
     kAgent,
     kServer,
     8 * kKiB,
     "2/s a driving robot"},
    {TopicId::agent_command, "weft/1/agent_command", "weft::idl::AgentCommand", false, kTo, false, prompt, 16,
     seconds(5), kServer, kAgent, 256 * kKiB, "as operators ask, repeated until answered"},
    {TopicId::agent_reply,
     "weft/1/agent_reply",
     "weft::idl::AgentReply",
     false,
     false,
     false,
     prompt,
     64,
     {},
     kAgent,
     kServer,
     kMiB,
     "one a command"},
    {TopicId::operator_request,
     "weft/1/operator_request",
     "weft::idl::OperatorRequest",
     false,
     false,
     false,
     prompt,
     16,
     {},
     kClient,
     kServer,
     256 * kKiB,
     "as operators ask, repeated until answered"},
    {TopicId::operator_reply, "weft/1/operator_reply", "weft::idl::OperatorReply", false, kTo, false, prompt, 64,
     seconds(5), kServer, kClient, kMiB, "one a request; two a second while long work is under way"},
    {TopicId::query,
     "weft/1/query",
     "weft::idl::Query",
     false,
     false,
     false,
     prompt,
     16,
     {},
     kClient,
     kServer,
     kKiB,
     "as operators ask, repeated until answered"},
    {TopicId::query_reply, "weft/1/query_reply", "weft::idl::QueryReply", false, kTo, false, prompt, 64, seconds(5),
     kServer, kClient, 4 * kMiB, "one a query, in parts"},
    {TopicId::event_note,
     "weft/1/event_note",
     "weft::idl::EventNote",
     false,
     false,
     false,
     prompt,
     256,
     {},
     kServer,
     kClient,
     8 * kKiB,
     "as things happen"},
    {TopicId::clock_probe, "weft/1/clock_probe", "weft::idl::ClockProbe", false, kTo, false, prompt, 4, seconds(1),
     kServer, kPeers, kKiB, "one in 10 s a peer"},
    {TopicId::clock_reply,
     "weft/1/clock_reply",
     "weft::idl::ClockReply",
     false,
     false,
     false,
     prompt,
     4,
     {},
     kPeers,
     kServer,
     kKiB,
     "one a probe"},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < kTable.size(); ++i) {
    if (static_cast<std::size_t>(kTable[i].id) != i) return false;
  }
  return true;
}
static_assert(in_order(), "the table stands in the order of TopicId");

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
