#include <gtest/gtest.h>

#include "agents/agent/content_cache.hpp"
#include "agents/agent/surroundings.hpp"
#include "core/network/codec.hpp"
#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

TEST(ContentsOfAgent, OfTheWholeWindowArriveDespiteLossAndRepeats) {
  Rig rig;
  rig.lay_out(70, 30);
  Random random(4);
  rig.doubled = true;
  rig.lost_down = [&](const msg::Message&) { return random.chance(0.4); };
  rig.run(2s);
  EXPECT_GT(rig.last<msg::RobotState>()->contents_missing, 0U);
  rig.run(120s);
  EXPECT_EQ(rig.last<msg::RobotState>()->contents_missing, 0U);
}

TEST(ContentsOfAgent, ResumeWhereTheyBrokeOff) {
  const Bytes bytes = some_content(1, 4 * msg::kChunkBytes);
  const SteadyTime now{};
  ContentCache cache(1 << 20, 1 << 20);
  cache.want({{hash_bytes(bytes), bytes.size()}}, now);
  ASSERT_TRUE(cache.due(now).has_value());
  msg::Chunk chunk;
  chunk.hash = hash_bytes(bytes);
  chunk.total = bytes.size();
  chunk.data.assign(bytes.begin(), bytes.begin() + msg::kChunkBytes);
  EXPECT_FALSE(cache.on_chunk(chunk, now));
  EXPECT_FALSE(cache.due(now).has_value());
  const auto again = cache.due(*cache.next());
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->items.front().offset, msg::kChunkBytes);
}

TEST(ContentsOfAgent, WithAnotherHashAreThrownAwayAndAskedForAgain) {
  const Bytes bytes = some_content(1, 10);
  const SteadyTime now{};
  ContentCache cache(1 << 20, 1 << 20);
  cache.want({{hash_bytes(bytes), bytes.size()}}, now);
  ASSERT_TRUE(cache.due(now).has_value());
  msg::Chunk chunk;
  chunk.hash = hash_bytes(bytes);
  chunk.total = 10;
  chunk.data = some_content(2, 10);
  EXPECT_FALSE(cache.on_chunk(chunk, now));
  EXPECT_EQ(cache.find(chunk.hash), nullptr);
  EXPECT_EQ(cache.counters().at("content: hash differs"), 1U);
  EXPECT_EQ(cache.due(*cache.next())->items.front().offset, 0U);
  chunk.data = bytes;
  EXPECT_TRUE(cache.on_chunk(chunk, now));
  EXPECT_EQ(*cache.find(chunk.hash), bytes);
}

TEST(ContentsOfAgent, WhatTwoPlacesShareIsAskedForOnce) {
  const ContentRef shared{hash_bytes(some_content(1, 10)), 10};
  const ContentRef other{hash_bytes(some_content(2, 10)), 10};
  const SteadyTime now{};
  ContentCache cache(1 << 20, 1 << 20);
  cache.want({shared, other, shared}, now);
  EXPECT_EQ(cache.missing(), 2U);
  const auto request = cache.due(now);
  ASSERT_TRUE(request.has_value());
  ASSERT_EQ(request->items.size(), 2U);
  EXPECT_EQ(request->items.front().hash, shared.hash);
}

TEST(ContentsOfAgent, NearestAreAskedForFirstAndGivenUpLast) {
  std::vector<Bytes> all;
  std::vector<ContentRef> refs;
  for (std::uint64_t i = 0; i < 10; ++i) {
    all.push_back(some_content(i, 1000));
    refs.push_back({hash_bytes(all.back()), 1000});
  }
  const SteadyTime now{};
  ContentCache cache(3500, 1 << 20);
  cache.want(refs, now);
  EXPECT_EQ(cache.missing(), 3U);
  const auto request = cache.due(now);
  ASSERT_EQ(request->items.size(), 3U);
  EXPECT_EQ(request->items.front().hash, refs.front().hash);
  for (std::size_t i = 10; i-- > 5;) cache.put(refs[i].hash, all[i]);
  for (std::size_t i = 0; i < 3; ++i) cache.put(refs[i].hash, all[i]);
  EXPECT_LE(cache.bytes(), 3500U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NE(cache.find(refs[i].hash), nullptr);
}

TEST(ContentsOfAgent, UnaskedOnesAreNotTaken) {
  ContentCache cache(1 << 20, 1 << 20);
  msg::Chunk chunk;
  chunk.data = some_content(2, 10);
  chunk.hash = hash_bytes(chunk.data);
  chunk.total = 10;
  EXPECT_FALSE(cache.on_chunk(chunk, SteadyTime{}));
  EXPECT_EQ(cache.find(chunk.hash), nullptr);
  EXPECT_EQ(cache.counters().at("chunk: not asked for"), 1U);
}

TEST(ContentsOfAgent, OwnTaughtOnesAreNotAskedFor) {
  Rig rig;
  rig.run(4s);
  rig.tell(rig.command(msg::AgentCommand::Kind::teach_start, 1));
  rig.run(2s);
  rig.tell(rig.command(msg::AgentCommand::Kind::teach_stop, 2));
  rig.run(60s);
  EXPECT_GT(rig.agent->window().places.size(), 10U);
  EXPECT_TRUE(rig.sent<msg::ContentRequest>().empty());
  EXPECT_EQ(rig.last<msg::RobotState>()->contents_missing, 0U);
}

TEST(Surroundings, RouteFirstThenOutwardsFromTheRobot) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 10);
  const Window window = make_window(rig.server.snapshot, WindowDefinition{});
  Route route = a_route(laid, 10, 1);
  route.places = {{laid, 8}, {laid, 9}};
  const auto order = nearest_first(window, PlaceId{laid, 3}, route, 0);
  ASSERT_EQ(order.size(), 10U);
  const auto is = [&](std::size_t i, std::uint32_t index) {
    return order[i].hash == window.place({laid, index})->content.hash;
  };
  EXPECT_TRUE(is(0, 8) && is(1, 9) && is(2, 3) && is(3, 2) && is(4, 4));
}

}  // namespace
}  // namespace weft::agents::test
