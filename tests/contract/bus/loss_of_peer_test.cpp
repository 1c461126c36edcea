#include <chrono>

#include "tests/contract/bus/contract.hpp"

namespace weft::contract {
namespace {

using msg::Role;
using PeerContract = BusContract;

msg::AgentCommand command(const PeerId& to, std::uint64_t number) {
  msg::AgentCommand made;
  made.header = header_of(kServerId);
  made.to = to;
  made.command = number;
  return made;
}

std::uint64_t last_command(const Peer& peer) {
  const auto commands = Fleet::all<msg::AgentCommand>(peer.got);
  return commands.empty() ? 0 : commands.back().command;
}

void greet(Fleet& fleet, Peer& peer, std::uint64_t incarnation = 1) {
  EXPECT_TRUE(peer.link.send(hello_of(peer.id, Role::agent, incarnation)));
  EXPECT_TRUE(fleet.until([&] {
    for (const auto& hello : Fleet::all<msg::Hello>(fleet.got)) {
      if (hello.peer == peer.id && hello.incarnation == incarnation) return true;
    }
    return false;
  }));
}

TEST_P(PeerContract, AKilledPeerStopsNobodyElse) {
  Peer& victim = fleet.start_peer(Role::agent, peer_id(2));
  Peer& survivor = fleet.start_peer(Role::agent, peer_id(3));
  greet(fleet, victim);
  greet(fleet, survivor);
  ASSERT_TRUE(fleet.server().send(command(victim.id, 1)));
  ASSERT_TRUE(fleet.until([&] { return last_command(victim) == 1; }));
  fleet.kill(victim);
  // Both keep being written to: the dead one's queue may fill, the living one's commands go through meanwhile.
  Duration slowest{};
  for (std::uint64_t number = 1; number <= 200; ++number) {
    const auto before = std::chrono::steady_clock::now();
    fleet.server().send(command(victim.id, number)).has_value();
    ASSERT_TRUE(fleet.server().send(command(survivor.id, number)));
    slowest = std::max<Duration>(slowest, std::chrono::steady_clock::now() - before);
    fleet.turn();
  }
  EXPECT_TRUE(fleet.until([&] { return last_command(survivor) == 200; }));
  EXPECT_LT(slowest, std::chrono::milliseconds(500)) << "writing to the dead one held up the living";
  ASSERT_TRUE(survivor.link.send(hello_of(survivor.id, Role::agent, 9)));
  EXPECT_TRUE(fleet.until([&] { return Fleet::all<msg::Hello>(fleet.got).back().incarnation == 9; }));
  fleet.server().bus().forget(victim.id);
  EXPECT_TRUE(fleet.server().send(command(survivor.id, 201)));
  EXPECT_TRUE(fleet.until([&] { return last_command(survivor) == 201; }));
}

TEST_P(PeerContract, AKilledPeerComesBackAndIsServedAnew) {
  ASSERT_TRUE(fleet.server().send(hello_of(kServerId, Role::server, 5)));
  Peer& first = fleet.start_peer(Role::agent, peer_id(2));
  greet(fleet, first, 1);
  ASSERT_TRUE(fleet.server().send(command(first.id, 1)));
  ASSERT_TRUE(fleet.until([&] { return last_command(first) == 1; }));
  fleet.kill(first);
  Peer& second = fleet.start_peer(Role::agent, first.id);
  greet(fleet, second, 2);
  EXPECT_TRUE(fleet.until([&] { return !Fleet::all<msg::Hello>(second.got).empty(); }));
  EXPECT_EQ(Fleet::all<msg::Hello>(second.got)[0].incarnation, 5U);
  int turns = 0;
  EXPECT_TRUE(fleet.until([&] {
    if (turns++ % 25 == 0) {
      EXPECT_TRUE(fleet.server().send(command(second.id, 2)));
    }
    return last_command(second) == 2;
  }));
}

TEST_P(PeerContract, AKilledReaderOfBulkSaysUnavailableAndHoldsNobodyUp) {
  Peer& victim = fleet.start_peer(Role::agent, peer_id(2));
  Peer& survivor = fleet.start_peer(Role::agent, peer_id(3));
  greet(fleet, victim);
  greet(fleet, survivor);
  msg::Chunk chunk{
      header_of(kServerId), victim.id, msg::ContentKind::content, msg::Coding::raw, {}, msg::kChunkBytes, 0, {}};
  chunk.hash.bytes.fill(1);
  chunk.data.resize(msg::kChunkBytes);
  const auto is_sent = [&] {
    const auto sent = fleet.server().send(chunk);
    if (!sent) {
      EXPECT_EQ(sent.error().code, ErrorCode::unavailable) << sent.error().message;
    }
    return sent.has_value();
  };
  ASSERT_TRUE(fleet.until([&] {
    is_sent();  // or not: a slow machine's victim may be slow to listen
    return !victim.got.empty();
  }));
  fleet.kill(victim);
  bool unavailable = false;
  for (std::uint64_t number = 1; number <= 300; ++number) {
    unavailable |= !is_sent();
    if (number % 50 == 0) {
      ASSERT_TRUE(fleet.server().send(command(survivor.id, number)));
    }
    if (unavailable && number >= 50) break;
  }
  // In process nothing waits for the dead, so nothing fills up.
  EXPECT_EQ(unavailable, GetParam().server.has_value());
  EXPECT_TRUE(fleet.until([&] { return last_command(survivor) > 0; }));
}

TEST_P(PeerContract, NothingIsKeptForClientsThatAreGone) {
  if (!GetParam().server) GTEST_SKIP() << "in process nothing is made for a peer";
  for (std::uint8_t number = 2; number <= 4; ++number) {
    Peer& client = fleet.start_peer(Role::client, peer_id(number));
    EXPECT_TRUE(client.link.send(hello_of(client.id, Role::client)));
    msg::OperatorReply reply;
    reply.header = header_of(kServerId);
    reply.to = client.id;
    reply.request = number;
    int turns = 0;
    ASSERT_TRUE(fleet.until([&] {
      if (turns++ % 25 == 0) std::ignore = fleet.server().send(reply);
      return !Fleet::all<msg::OperatorReply>(client.got).empty();
    }));
    fleet.kill(client);  // no word of farewell: its lease tells
  }
  EXPECT_GT(fleet.server().bus().counters().peers, 0U);
  EXPECT_TRUE(fleet.until([&] { return fleet.server().bus().counters().peers == 0; }));
}

/// Shows that it disturbs nobody if a vendor has to say much of itself anew by then.
TEST_P(PeerContract, AfterManyClientsThatAreGoneTheOthersAreServedAsBefore) {
  if (!GetParam().server) GTEST_SKIP() << "in process nothing is made for a peer";
  Peer& survivor = fleet.start_peer(Role::agent, peer_id(1));
  greet(fleet, survivor);
  std::uint64_t request = 0;
  const auto is_reached = [&](Peer& peer) {
    int turns = 0;
    return fleet.until([&] {
      if (turns++ % 25 == 0) std::ignore = fleet.server().send(command(peer.id, ++request));
      return last_command(peer) == request && request > 0;
    });
  };
  ASSERT_TRUE(is_reached(survivor));
  for (std::uint8_t number = 50; number < 250; ++number) {
    msg::OperatorReply reply;
    reply.header = header_of(kServerId);
    reply.to = peer_id(number);
    EXPECT_TRUE(fleet.server().send(reply));
  }
  EXPECT_GT(fleet.server().bus().counters().peers, 100U);
  EXPECT_TRUE(fleet.until([&] { return fleet.server().bus().counters().peers == 1; }));
  EXPECT_TRUE(is_reached(survivor));
  Peer& newcomer = fleet.start_peer(Role::agent, peer_id(2));
  greet(fleet, newcomer);
  EXPECT_TRUE(is_reached(newcomer));
}

WEFT_ON_EACH_PAIRING(PeerContract);

}  // namespace
}  // namespace weft::contract
