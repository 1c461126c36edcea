#include <algorithm>

#include "tests/contract/bus/contract.hpp"

namespace weft::contract {
namespace {

using msg::Role;
using StateContract = BusContract;

msg::RobotState state_of(const PeerId& robot, std::uint64_t frame) {
  msg::RobotState state;
  state.header = header_of(robot);
  state.frame = frame;
  return state;
}

std::uint64_t last_frame(const std::vector<msg::Message>& messages, const PeerId& robot) {
  std::uint64_t last = 0;
  for (const auto& state : Fleet::all<msg::RobotState>(messages)) {
    if (state.header.sender == robot) last = state.frame;
  }
  return last;
}

TEST_P(StateContract, TheLastStateOfEachKeyArrives) {
  std::vector<Peer*> robots;
  for (std::uint8_t i = 2; i < 5; ++i) robots.push_back(&fleet.start_peer(Role::agent, peer_id(i)));
  for (std::uint64_t frame = 1; frame <= 20; ++frame) {
    for (Peer* const robot : robots) ASSERT_TRUE(robot->link.send(state_of(robot->id, frame)));
  }
  EXPECT_TRUE(fleet.until([&] {
    return std::all_of(robots.begin(), robots.end(), [&](Peer* r) { return last_frame(fleet.got, r->id) == 20; });
  }));
}

TEST_P(StateContract, ALatePeerGetsTheServersLastHello) {
  ASSERT_TRUE(fleet.server().send(hello_of(kServerId, Role::server, 7)));
  ASSERT_TRUE(fleet.server().send(hello_of(kServerId, Role::server, 8)));
  fleet.turn();
  Peer& late = fleet.start_peer(Role::client, peer_id(2));
  ASSERT_TRUE(fleet.until([&] { return !late.got.empty(); }));
  for (int i = 0; i < 20; ++i) fleet.turn();
  const auto hellos = Fleet::all<msg::Hello>(late.got);
  ASSERT_EQ(hellos.size(), 1U);
  EXPECT_EQ(hellos[0].incarnation, 8U);
}

TEST_P(StateContract, ALateServerGetsTheLastHelloAndStateOfEachPeer) {
  fleet.stop_server();
  fleet.start_server();
  Peer& first = fleet.start_peer(Role::agent, peer_id(2));
  Peer& second = fleet.start_peer(Role::client, peer_id(3));
  ASSERT_TRUE(first.link.send(hello_of(first.id, Role::agent)));
  ASSERT_TRUE(second.link.send(hello_of(second.id, Role::client)));
  ASSERT_TRUE(first.link.send(state_of(first.id, 1)));
  ASSERT_TRUE(first.link.send(state_of(first.id, 2)));
  fleet.stop_server();
  fleet.got.clear();
  fleet.start_server();
  EXPECT_TRUE(fleet.until(
      [&] { return Fleet::all<msg::Hello>(fleet.got).size() >= 2 && last_frame(fleet.got, first.id) == 2; }));
}

TEST_P(StateContract, NobodyHearsItselfAndPeersDoNotHearEachOther) {
  Peer& one = fleet.start_peer(Role::agent, peer_id(2));
  Peer& other = fleet.start_peer(Role::agent, peer_id(3));
  ASSERT_TRUE(one.link.send(hello_of(one.id, Role::agent)));
  ASSERT_TRUE(fleet.server().send(hello_of(kServerId, Role::server)));
  ASSERT_TRUE(fleet.until([&] { return !fleet.got.empty() && !other.got.empty(); }));
  for (int i = 0; i < 20; ++i) fleet.turn();
  EXPECT_EQ(Fleet::all<msg::Hello>(other.got).size(), 1U);
  EXPECT_EQ(Fleet::all<msg::Hello>(other.got)[0].peer, kServerId);
  EXPECT_EQ(Fleet::all<msg::Hello>(fleet.got).size(), 1U) << "a server does not hear itself";
}

WEFT_ON_EACH_PAIRING(StateContract);

}  // namespace
}  // namespace weft::contract
