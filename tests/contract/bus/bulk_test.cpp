#include <algorithm>
#include <map>

#include "tests/contract/bus/contract.hpp"

namespace weft::contract {
namespace {

using msg::Role;
using BulkContract = BusContract;
constexpr std::size_t kBulk = 5'000'000;

Bytes pattern() {
  Bytes bytes(kBulk);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>((i * 2654435761U) >> 13U);
  return bytes;
}

/// Sends a content from an offset on, as much as the bus takes at a time.
class Sender {
 public:
  Sender(bus::Link& link, const PeerId& from, const PeerId& to, const Bytes& content)
      : link_(link), from_(from), to_(to), content_(content) {}
  void start_at(std::size_t offset) { offset_ = offset; }
  bool done() const { return offset_ >= content_.size(); }
  /// Sends up to `chunks` more.
  void send(int chunks) {
    for (; chunks > 0 && !done(); --chunks) {
      const std::size_t size = std::min(msg::kChunkBytes, content_.size() - offset_);
      msg::Chunk chunk{header_of(from_), to_, msg::ContentKind::cloud, msg::Coding::raw, hash(), content_.size(),
                       offset_,          {}};
      chunk.data.assign(content_.begin() + static_cast<std::ptrdiff_t>(offset_),
                        content_.begin() + static_cast<std::ptrdiff_t>(offset_ + size));
      const auto sent = link_.send(chunk);
      if (!sent) {
        EXPECT_EQ(sent.error().code, ErrorCode::unavailable) << sent.error().message;
        return;
      }
      offset_ += size;
    }
  }
  static ContentHash hash() {
    ContentHash made;
    made.bytes.fill(7);
    return made;
  }

 private:
  bus::Link& link_;
  PeerId from_, to_;
  const Bytes& content_;
  std::size_t offset_ = 0;
};

/// Puts chunks together; knows the first gap.
class Receiver {
 public:
  void take(const std::vector<msg::Message>& messages) {
    for (; seen_ < messages.size(); ++seen_) {
      const auto* const chunk = std::get_if<msg::Chunk>(&messages[seen_]);
      if (chunk != nullptr) chunks_[chunk->offset] = chunk->data;
    }
  }
  std::size_t complete_to() const {
    std::size_t end = 0;
    for (const auto& [offset, data] : chunks_) {
      if (offset != end) break;
      end += data.size();
    }
    return end;
  }
  Bytes content() const {
    Bytes all;
    for (const auto& [offset, data] : chunks_) all.insert(all.end(), data.begin(), data.end());
    return all;
  }

 private:
  std::size_t seen_ = 0;
  std::map<std::size_t, Bytes> chunks_;
};

/// Returns the position in `messages` of the last one that is an M.
template <class M>
std::size_t last_of(const std::vector<msg::Message>& messages) {
  std::size_t last = 0;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (std::holds_alternative<M>(messages[i])) last = i;
  }
  return last;
}

TEST_P(BulkContract, FiveMegabytesUpWhileSmallOnesFlow) {
  Peer& agent = fleet.start_peer(Role::agent, peer_id(2));
  ASSERT_TRUE(agent.link.send(hello_of(agent.id, Role::agent)));
  ASSERT_TRUE(fleet.until([&] { return !fleet.got.empty(); }));
  const Bytes content = pattern();
  Sender sender(agent.link, agent.id, kServerId, content);
  Receiver receiver;
  std::uint64_t small = 0;
  int quiet = 0;
  ASSERT_TRUE(fleet.until([&] {
    const std::size_t before = receiver.complete_to();
    sender.send(8);
    msg::AgentReply reply;
    reply.header = header_of(agent.id);
    reply.command = ++small;
    EXPECT_TRUE(agent.link.send(reply));
    receiver.take(fleet.got);
    quiet = receiver.complete_to() == before ? quiet + 1 : 0;
    constexpr int kLong = 100;  // turns: what is missing then is lost, and is sent again from the gap on
    if (sender.done() && quiet > kLong) sender.start_at(receiver.complete_to()), quiet = 0;
    return receiver.complete_to() == content.size();
  }));
  EXPECT_TRUE(receiver.content() == content);
  const auto first_small = std::find_if(fleet.got.begin(), fleet.got.end(), [](const msg::Message& m) {
    return std::holds_alternative<msg::AgentReply>(m);
  });
  ASSERT_NE(first_small, fleet.got.end());
  EXPECT_LT(static_cast<std::size_t>(first_small - fleet.got.begin()), last_of<msg::Chunk>(fleet.got));
  EXPECT_GE(Fleet::all<msg::AgentReply>(fleet.got).size(), 3U) << "small ones arrived while the bulk was on its way";
}

TEST_P(BulkContract, FiveMegabytesDownWhileOthersAreServed) {
  Peer& reader = fleet.start_peer(Role::agent, peer_id(2));
  Peer& bystander = fleet.start_peer(Role::agent, peer_id(3));
  ASSERT_TRUE(reader.link.send(hello_of(reader.id, Role::agent)));
  ASSERT_TRUE(bystander.link.send(hello_of(bystander.id, Role::agent)));
  ASSERT_TRUE(fleet.until([&] { return fleet.got.size() >= 2; }));
  const Bytes content = pattern();
  Sender sender(fleet.server(), kServerId, reader.id, content);
  Receiver receiver;
  msg::AgentCommand order;
  order.header = header_of(kServerId);
  order.to = bystander.id;
  ASSERT_TRUE(fleet.server().send(order));
  ASSERT_TRUE(fleet.until([&] { return !bystander.got.empty(); }));
  std::size_t bystander_had = 0;
  int quiet = 0;
  ASSERT_TRUE(fleet.until([&] {
    const std::size_t before = receiver.complete_to();
    sender.send(8);
    ++order.command;
    EXPECT_TRUE(fleet.server().send(order));
    receiver.take(reader.got);
    quiet = receiver.complete_to() == before ? quiet + 1 : 0;
    constexpr int kLong = 100;
    if (sender.done() && quiet > kLong) sender.start_at(receiver.complete_to()), quiet = 0;
    if (receiver.complete_to() < content.size()) bystander_had = Fleet::all<msg::AgentCommand>(bystander.got).size();
    return receiver.complete_to() == content.size();
  }));
  EXPECT_TRUE(receiver.content() == content);
  EXPECT_TRUE(Fleet::all<msg::Chunk>(bystander.got).empty());
  EXPECT_GT(bystander_had, 1U) << "the other peer had to wait for the bulk to end";
}

WEFT_ON_EACH_PAIRING(BulkContract);

}  // namespace
}  // namespace weft::contract
