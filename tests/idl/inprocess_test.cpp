#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "idl/bus/inprocess/net.hpp"
#include "idl/bus/link.hpp"

namespace weft::bus {
namespace {

using namespace std::chrono_literals;
using msg::Role;

PeerId peer(std::uint8_t number) {
  PeerId id;
  id.bytes.fill(number);
  return id;
}
const PeerId kServer = peer(1);

msg::Hello hello(const PeerId& self, Role role, std::uint64_t incarnation = 1) {
  msg::Hello made;
  made.peer = self;
  made.role = role;
  made.incarnation = incarnation;
  return made;
}

msg::Query query(std::uint64_t number) {
  msg::Query made;
  made.header.sender = peer(2);
  made.request = number;
  return made;
}

std::vector<std::uint64_t> queries(Link& link) {
  std::vector<std::uint64_t> numbers;
  while (const auto message = link.take()) {
    if (const auto* const found = std::get_if<msg::Query>(&*message)) numbers.push_back(found->request);
  }
  return numbers;
}

struct InProcess : testing::Test {
  InProcessNet net{Random(5)};
  Link server{net.attach(Role::server, kServer)};
  Link client{net.attach(Role::client, peer(2))};
  SteadyTime at(Duration since_start) { return SteadyTime(since_start); }
};

TEST_F(InProcess, DeliversWhenTimeHasCome) {
  net.set_faults({.delay_min = 20ms, .delay_max = 20ms});
  ASSERT_TRUE(client.send(query(1)));
  EXPECT_EQ(net.next_delivery(), at(20ms));
  net.deliver_until(at(19ms));
  EXPECT_TRUE(queries(server).empty());
  net.deliver_until(at(20ms));
  EXPECT_EQ(queries(server), std::vector<std::uint64_t>{1});
  EXPECT_FALSE(net.next_delivery());
}

TEST_F(InProcess, AddressedMessagesReachTheirPeerAlone) {
  Link other(net.attach(Role::client, peer(3)));
  msg::OperatorReply reply;
  reply.header.sender = kServer;
  reply.to = peer(3);
  ASSERT_TRUE(server.send(reply));
  net.deliver_until(at(0ms));
  EXPECT_TRUE(other.take());
  EXPECT_FALSE(client.take());
}

TEST_F(InProcess, PeersDoNotHearEachOther) {
  Link agent(net.attach(Role::agent, peer(4)));
  ASSERT_TRUE(agent.send(hello(peer(4), Role::agent)));
  net.deliver_until(at(0ms));
  EXPECT_TRUE(server.take());
  EXPECT_FALSE(client.take());
}

TEST_F(InProcess, LateJoinerGetsTheLastOfEachKey) {
  ASSERT_TRUE(server.send(hello(kServer, Role::server, 7)));
  ASSERT_TRUE(server.send(hello(kServer, Role::server, 8)));
  ASSERT_TRUE(client.send(query(1)));
  net.deliver_until(at(0ms));
  Link late(net.attach(Role::agent, peer(4)));
  net.deliver_until(at(1ms));
  const auto message = late.take();
  ASSERT_TRUE(message);
  EXPECT_EQ(std::get<msg::Hello>(*message).incarnation, 8U);
  EXPECT_FALSE(late.take());
}

TEST_F(InProcess, LossTakesItsShareAndDuplicationDoubles) {
  net.set_faults({.loss = 0.25, .duplication = 0.5});
  for (std::uint64_t i = 0; i < 4000; ++i) ASSERT_TRUE(client.send(query(i)));
  net.deliver_until(at(0ms));
  const std::vector<std::uint64_t> got = queries(server);
  const std::set<std::uint64_t> unique(got.begin(), got.end());
  EXPECT_NEAR(static_cast<double>(unique.size()), 3000.0, 150.0);
  EXPECT_NEAR(static_cast<double>(got.size()), 4500.0, 250.0);
}

TEST_F(InProcess, OrderHoldsUnlessReorderingIsAskedFor) {
  net.set_faults({.delay_min = 0ms, .delay_max = 100ms});
  for (std::uint64_t i = 0; i < 200; ++i) ASSERT_TRUE(client.send(query(i)));
  net.deliver_until(at(1s));
  std::vector<std::uint64_t> got = queries(server);
  EXPECT_EQ(got.size(), 200U);
  EXPECT_TRUE(std::is_sorted(got.begin(), got.end()));
  net.set_faults({.reordering = 1.0, .delay_min = 0ms, .delay_max = 100ms});
  for (std::uint64_t i = 0; i < 200; ++i) ASSERT_TRUE(client.send(query(i)));
  net.deliver_until(at(2s));
  got = queries(server);
  EXPECT_EQ(got.size(), 200U);
  EXPECT_FALSE(std::is_sorted(got.begin(), got.end()));
}

TEST_F(InProcess, PartitionLosesAndHealingBringsState) {
  net.partition(peer(2), Cut::all);
  ASSERT_TRUE(client.send(query(1)));
  ASSERT_TRUE(server.send(hello(kServer, Role::server, 7)));
  net.deliver_until(at(1s));
  EXPECT_FALSE(server.take());
  EXPECT_FALSE(client.take());
  net.partition(peer(2), Cut::none);
  net.deliver_until(at(2s));
  EXPECT_TRUE(client.take());
  EXPECT_FALSE(server.take());
}

TEST_F(InProcess, ACutOfOneDirectionLeavesTheOther) {
  net.partition(peer(2), Cut::sent);
  ASSERT_TRUE(client.send(query(1)));
  ASSERT_TRUE(server.send(hello(kServer, Role::server, 7)));
  net.deliver_until(at(1s));
  EXPECT_FALSE(server.take());
  EXPECT_TRUE(client.take());
  net.partition(peer(2), Cut::received);
  ASSERT_TRUE(client.send(query(2)));
  ASSERT_TRUE(server.send(hello(kServer, Role::server, 8)));
  net.deliver_until(at(2s));
  EXPECT_EQ(queries(server), std::vector<std::uint64_t>{2});
  EXPECT_FALSE(client.take());
  net.partition(peer(2), Cut::none);
  net.deliver_until(at(3s));
  EXPECT_TRUE(client.take());
}

TEST_F(InProcess, AClosedLinkTellsStateOnceItIsOpenAnew) {
  net.set_faults({.delay_min = 10ms, .delay_max = 10ms});
  ASSERT_TRUE(client.send(query(1)));
  net.deliver_until(at(1s));
  ASSERT_TRUE(client.send(query(2)));
  net.set_open(kServer, false);
  EXPECT_FALSE(server.bus().is_open());
  ASSERT_TRUE(server.send(hello(kServer, Role::server, 7)));
  msg::QueryReply answer;
  answer.header.sender = kServer;
  answer.to = peer(2);
  const auto refused = server.send(answer);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unavailable);
  net.set_open(kServer, true);
  net.deliver_until(at(2s));
  EXPECT_EQ(queries(server), std::vector<std::uint64_t>{1});
  EXPECT_TRUE(client.take());
}

TEST_F(InProcess, ADetachedPeerIsGoneWithWhatWasUnderWay) {
  net.set_faults({.delay_min = 10ms, .delay_max = 10ms});
  ASSERT_TRUE(client.send(query(1)));
  net.detach(peer(2));
  const auto sent = client.send(query(2));
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().code, ErrorCode::unavailable);
  net.deliver_until(at(1s));
  EXPECT_TRUE(queries(server).empty());
  Link again(net.attach(Role::client, peer(2)));
  ASSERT_TRUE(again.send(query(3)));
  net.deliver_until(at(2s));
  EXPECT_EQ(queries(server), std::vector<std::uint64_t>{3});
}

TEST_F(InProcess, SmallOnesPassBulkOnANarrowLink) {
  net.set_faults({.bytes_per_second = 1'000'000});
  Link agent(net.attach(Role::agent, peer(4)));
  msg::Chunk chunk;
  chunk.header.sender = peer(4);
  chunk.hash.bytes.fill(1);
  chunk.data.resize(msg::kChunkBytes);
  chunk.total = chunk.data.size();
  for (int i = 0; i < 80; ++i) ASSERT_TRUE(agent.send(chunk));
  msg::AgentReply reply;
  reply.header.sender = peer(4);
  ASSERT_TRUE(agent.send(reply));
  net.deliver_until(at(100ms));
  std::size_t chunks = 0, replies = 0;
  while (const auto message = server.take()) ++(std::holds_alternative<msg::Chunk>(*message) ? chunks : replies);
  EXPECT_EQ(replies, 1U);
  EXPECT_EQ(chunks, 1U);
  net.deliver_until(at(6s));
  while (server.take()) ++chunks;
  EXPECT_EQ(chunks, 80U);
}

/// Returns what the server gets, in order, of a run with every fault on.
std::vector<std::uint64_t> run(std::uint64_t seed) {
  InProcessNet net{Random(seed)};
  Link server(net.attach(Role::server, kServer));
  std::vector<Link> clients;
  for (std::uint8_t i = 2; i < 6; ++i) clients.emplace_back(net.attach(Role::client, peer(i)));
  net.set_faults({.loss = 0.1,
                  .duplication = 0.1,
                  .reordering = 0.3,
                  .delay_min = 1ms,
                  .delay_max = 50ms,
                  .bytes_per_second = 100'000});
  std::vector<std::uint64_t> got;
  for (std::uint64_t i = 0; i < 400; ++i) {
    EXPECT_TRUE(clients[i % clients.size()].send(query(i)));
    net.deliver_until(SteadyTime(i * 3ms));
    for (const std::uint64_t number : queries(server)) got.push_back(number);
  }
  return got;
}

TEST(InProcessNet, TheSeedDecides) {
  EXPECT_EQ(run(11), run(11));
  EXPECT_NE(run(11), run(12));
}

TEST_F(InProcess, RefusalsAreNamedAndCounted) {
  std::unique_ptr<Bus> liar = net.attach(Role::client, peer(9));
  const Result<Encoded> good = encode(query(1), Role::client);
  ASSERT_TRUE(good);
  Bytes cut = good->cdr;
  cut.resize(cut.size() - 3);
  ASSERT_TRUE(liar->publish(good->topic, {}, cut));
  msg::Query wrong = query(2);
  wrong.kind = msg::Query::Kind{50};
  const Result<Encoded> bad = encode(wrong, Role::client);
  ASSERT_TRUE(bad);
  ASSERT_TRUE(liar->publish(bad->topic, {}, bad->cdr));
  ASSERT_TRUE(liar->publish(bad->topic, {}, bad->cdr));
  const Result<void> oversized = liar->publish(good->topic, {}, Bytes(5000));
  EXPECT_FALSE(oversized);
  EXPECT_EQ(liar->counters().refused_size, 1U);
  net.deliver_until(at(0ms));
  EXPECT_FALSE(server.take());
  const std::map<std::string, std::uint64_t> expected = {
      {"weft/1/query: Query.kind must be from 1 to 10", 2},
      {"weft/1/query: weft::idl::Query is not well-formed CDR", 1}};
  EXPECT_EQ(server.refusals(), expected);
  EXPECT_EQ(server.drain_refusal_texts().size(), 3U);
  EXPECT_TRUE(server.drain_refusal_texts().empty());
}

}  // namespace
}  // namespace weft::bus
