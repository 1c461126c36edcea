#include <algorithm>

#include "core/protocol/version.hpp"
#include "idl/bus/topics.hpp"
#include "tests/contract/bus/contract.hpp"

namespace weft::contract {
namespace {

using msg::Role;
using RefusalContract = BusContract;

bus::Encoded query(const PeerId& client, msg::Query::Kind kind) {
  msg::Query made;
  made.header = header_of(client);
  made.kind = kind;
  made.robot = "r1";
  return bus::encode(made, Role::client).value();
}

/// Returns how often the server refused for a reason that contains `text`.
std::uint64_t refused(Fleet& fleet, std::string_view text) {
  std::uint64_t times = 0;
  for (const auto& [reason, count] : fleet.server().refusals()) {
    if (reason.find(text) != std::string::npos) times += count;
  }
  return times;
}

/// Publishes until the server has refused `times` for the reason: the first ones may find nobody there yet.
bool published_and_refused(Fleet& fleet, Peer& liar, const bus::Encoded& message, std::string_view reason) {
  return fleet.until([&] {
    EXPECT_TRUE(liar.link.bus().publish(message.topic, message.to, message.cdr));
    for (int i = 0; i < 10; ++i) fleet.turn();
    return refused(fleet, reason) >= 2;
  });
}

TEST_P(RefusalContract, ValuesOutOfBoundsAreNamedAndCounted) {
  Peer& liar = fleet.start_peer(Role::client, peer_id(2));
  const bus::Encoded wrong = query(liar.id, msg::Query::Kind{77});
  EXPECT_TRUE(published_and_refused(fleet, liar, wrong, "weft/1/query: Query.kind must be from 1 to 10"));
  EXPECT_TRUE(Fleet::all<msg::Query>(fleet.got).empty());
  EXPECT_FALSE(fleet.server().drain_refusal_texts().empty());
}

TEST_P(RefusalContract, BytesThatAreNoMessageAreRefusedAtOneEndOrTheOther) {
  Peer& liar = fleet.start_peer(Role::client, peer_id(2));
  bus::Encoded cut = query(liar.id, msg::Query::Kind::robots);
  cut.cdr.resize(cut.cdr.size() - 6);
  if (GetParam().peer == bus::Vendor::cyclonedds) {  // looks at what it sends
    const Result<void> sent = liar.link.bus().publish(cut.topic, cut.to, cut.cdr);
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().code, ErrorCode::invalid);
    EXPECT_THAT(sent.error().message, testing::HasSubstr("refused the bytes as not of type weft::idl::Query"));
    EXPECT_EQ(liar.link.bus().counters().publish_failed, 1U);
    return;
  }
  const bool server_looks = GetParam().server == bus::Vendor::cyclonedds;
  EXPECT_TRUE(published_and_refused(
      fleet, liar, cut, server_looks ? "bus: bytes are not of the topic's type" : "is not well-formed CDR"));
}

TEST_P(RefusalContract, OversizedIsRefusedBySenderAndReader) {
  Peer& honest = fleet.start_peer(Role::client, peer_id(2));
  bus::Encoded large = query(honest.id, msg::Query::Kind::robots);
  // A well-formed query whose robot's name makes it larger than the topic allows.
  msg::Query made;
  made.header = header_of(honest.id);
  made.robot.assign(60, 'r');
  large.cdr = bus::encode(made, Role::client).value().cdr;
  const Bytes text(60, 'r');
  const auto found = std::search(large.cdr.begin(), large.cdr.end(), text.begin(), text.end());
  ASSERT_NE(found, large.cdr.end());
  const auto text_at = static_cast<std::size_t>(found - large.cdr.begin());
  constexpr std::uint32_t kLength = 61 + 617 * 8;  // what follows stays aligned
  large.cdr.insert(found, kLength - 61, 'r');
  for (unsigned i = 0; i < 4; ++i) large.cdr[text_at - 4 + i] = static_cast<std::uint8_t>(kLength >> (8 * i));
  const Result<void> sent = honest.link.bus().publish(large.topic, large.to, large.cdr);
  ASSERT_FALSE(sent);
  EXPECT_THAT(sent.error().message, testing::HasSubstr("weft/1/query: a message of"));
  EXPECT_EQ(honest.link.bus().counters().refused_size, 1U);
  if (!GetParam().peer) return;  // in process there is no sender without the table
  Peer& liar = fleet.start_peer(Role::client, peer_id(3), true);
  EXPECT_TRUE(published_and_refused(fleet, liar, large, "bus: message is larger than its topic's bound"));
  EXPECT_TRUE(Fleet::all<msg::Query>(fleet.got).empty());
}

TEST_P(RefusalContract, AGoodMessageAfterBadOnesIsTaken) {
  Peer& liar = fleet.start_peer(Role::client, peer_id(2));
  EXPECT_TRUE(published_and_refused(fleet, liar, query(liar.id, msg::Query::Kind{0}), "Query.kind"));
  const bus::Encoded good = query(liar.id, msg::Query::Kind::goals);
  ASSERT_TRUE(liar.link.bus().publish(good.topic, good.to, good.cdr));
  EXPECT_TRUE(fleet.until([&] { return !Fleet::all<msg::Query>(fleet.got).empty(); }));
}

TEST_P(RefusalContract, OlderAndNewerPeersAreReadAndToldApart) {
  const auto greeting = [](const PeerId& id, std::uint16_t version) {
    msg::Hello hello = hello_of(id, Role::agent);
    hello.protocol_min = hello.protocol_max = version;
    hello.name = "r" + std::to_string(version);
    return hello;
  };
  Peer& older = fleet.start_peer(Role::agent, peer_id(2));
  Peer& newer = fleet.start_peer(Role::agent, peer_id(3));
  ASSERT_TRUE(older.link.send(greeting(older.id, 0)));
  ASSERT_TRUE(newer.link.send(greeting(newer.id, 2)));
  ASSERT_TRUE(fleet.until([&] { return Fleet::all<msg::Hello>(fleet.got).size() >= 2; }));
  for (const auto& hello : Fleet::all<msg::Hello>(fleet.got)) {
    const bool is_older = hello.peer == older.id;
    const auto alone = msg::negotiate({1, 1}, hello);
    ASSERT_FALSE(alone);
    EXPECT_EQ(alone.error().code, is_older ? ErrorCode::stale : ErrorCode::newer);
    EXPECT_EQ(msg::negotiate({0, 1}, hello).has_value(), is_older);   // a server of N and N-1
    EXPECT_EQ(msg::negotiate({1, 2}, hello).has_value(), !is_older);  // one of N+1 and N
  }
}

WEFT_ON_EACH_PAIRING(RefusalContract);

}  // namespace
}  // namespace weft::contract
