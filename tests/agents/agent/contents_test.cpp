#include <gtest/gtest.h>

#include "agents/agent/content_cache.hpp"
#include "agents/agent/surroundings.hpp"
#include "core/network/codec.hpp"
#include "storage/content_coder.hpp"
#include "tests/agents/agent/rig.hpp"
#include "tests/storage/clouds/sample_clouds.hpp"

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

/// Holds contents that shrink, as a server keeps and sends them.
struct Lent {
  Bytes content;
  storage::Coded coded;
  ContentRef ref;

  explicit Lent(std::size_t size) {
    Random random(size);
    for (std::size_t at = 0; at < size; ++at) content.push_back(static_cast<std::uint8_t>(random.below(16)));
    code();
  }
  explicit Lent(Bytes cloud) : content(std::move(cloud)) { code(); }
  msg::Chunk piece(std::uint64_t offset, std::uint64_t most = msg::kChunkBytes) const {
    return cut(coded.coding, coded.bytes, offset, most);
  }
  msg::Chunk raw_piece(std::uint64_t offset, std::uint64_t most = msg::kChunkBytes) const {
    return cut(msg::Coding::raw, content, offset, most);
  }

 private:
  void code() {
    coded = storage::ContentCoder().encode(content);
    ref = {hash_bytes(content), content.size()};
  }
  msg::Chunk cut(msg::Coding coding, const Bytes& bytes, std::uint64_t offset, std::uint64_t most) const {
    msg::Chunk chunk;
    chunk.coding = coding;
    chunk.hash = ref.hash;
    chunk.total = bytes.size();
    chunk.offset = offset;
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(offset);
    chunk.data.assign(begin, begin + static_cast<std::ptrdiff_t>(std::min(most, bytes.size() - offset)));
    return chunk;
  }
};

/// Holds a cache that has asked for that content.
struct Asking {
  SteadyTime now{};
  ContentCache cache{1 << 20, 1 << 20};

  explicit Asking(const Lent& lent) {
    cache.want({lent.ref}, now);
    EXPECT_TRUE(cache.due(now).has_value());
  }
  bool take(const msg::Chunk& chunk) { return cache.on_chunk(chunk, now); }
  std::uint64_t asks_from() {
    now = *cache.next();
    const auto request = cache.due(now);
    return request.has_value() ? request->items.front().offset : ~0ULL;
  }
  std::uint64_t counted(const std::string& what) const {
    const auto found = cache.counters().find(what);
    return found == cache.counters().end() ? 0 : found->second;
  }
};

TEST(ContentsOfAgent, AsTheyAreStoredAreExpandedVerifiedAndCountedByTheirOwnSize) {
  const Lent lent(3 * msg::kChunkBytes);
  ASSERT_EQ(lent.coded.coding, msg::Coding::zstd);
  ASSERT_GT(lent.coded.bytes.size(), msg::kChunkBytes);
  Asking asking(lent);
  EXPECT_FALSE(asking.take(lent.piece(0)));
  EXPECT_EQ(asking.asks_from(), msg::kChunkBytes) << "resumes among the coded bytes";
  EXPECT_TRUE(asking.take(lent.piece(msg::kChunkBytes)));
  EXPECT_EQ(*asking.cache.find(lent.ref.hash), lent.content);
  EXPECT_EQ(asking.cache.bytes(), lent.ref.size);
  EXPECT_EQ(asking.cache.missing(), 0U);
  EXPECT_FALSE(asking.cache.next().has_value()) << "nothing is under way";
}

TEST(ContentsOfAgent, CloudsWithFeaturesTravelAsCloudsAndAreExpanded) {
  const Lent lent(clouds::sample::place_content(3, 60'000));
  ASSERT_EQ(lent.coded.coding, msg::Coding::cloud);
  ASSERT_GT(lent.coded.bytes.size(), msg::kChunkBytes);
  Asking asking(lent);
  for (std::uint64_t at = 0; at < lent.coded.bytes.size(); at += msg::kChunkBytes) {
    EXPECT_EQ(asking.take(lent.piece(at)), at + msg::kChunkBytes >= lent.coded.bytes.size());
  }
  EXPECT_EQ(*asking.cache.find(lent.ref.hash), lent.content);
  EXPECT_EQ(asking.cache.bytes(), lent.ref.size);
}

TEST(ContentsOfAgent, InAnotherFormThanTheyBeganAreBegunAnew) {
  const Lent lent(3 * msg::kChunkBytes);
  Asking asking(lent);
  EXPECT_FALSE(asking.take(lent.piece(0)));
  EXPECT_FALSE(asking.take(lent.raw_piece(msg::kChunkBytes))) << "the server restarted with another store";
  EXPECT_EQ(asking.counted("content: begun anew in another form"), 1U);
  EXPECT_EQ(asking.asks_from(), 0U);
  EXPECT_FALSE(asking.take(lent.raw_piece(0)));
  EXPECT_TRUE(asking.take(lent.raw_piece(2 * msg::kChunkBytes)));
  EXPECT_EQ(*asking.cache.find(lent.ref.hash), lent.content);
}

TEST(ContentsOfAgent, ThatCannotBeExpandedAreThrownAwayAndAskedForAgain) {
  const Lent lent(1000);
  for (const std::size_t damaged : {std::size_t{0}, std::size_t{5}, lent.coded.bytes.size() / 2}) {
    Asking asking(lent);
    msg::Chunk chunk = lent.piece(0);
    chunk.data[damaged] ^= 0x55U;
    EXPECT_FALSE(asking.take(chunk));
    EXPECT_EQ(asking.counted("content: cannot be expanded") + asking.counted("content: hash differs"), 1U);
    EXPECT_EQ(asking.asks_from(), 0U);
    EXPECT_TRUE(asking.take(lent.piece(0)));
    EXPECT_EQ(*asking.cache.find(lent.ref.hash), lent.content);
  }
}

TEST(ContentsOfAgent, LargerThanWhatIsWantedAreNotBegun) {
  const Lent lent(1000);
  Asking asking(lent);
  EXPECT_FALSE(asking.take(lent.piece(0, 100)));
  for (const msg::Coding coding : {msg::Coding::raw, msg::Coding::zstd, msg::Coding::cloud}) {
    msg::Chunk chunk = lent.piece(0);
    chunk.coding = coding;
    chunk.total = msg::kContentBytes;
    EXPECT_FALSE(asking.take(chunk));
    chunk.total = coding == msg::Coding::raw ? 999 : 1000;
    EXPECT_FALSE(asking.take(chunk));
  }
  EXPECT_EQ(asking.counted("chunk: out of bounds"), 6U);
  EXPECT_EQ(asking.asks_from(), 100U) << "what had come was kept";
}

TEST(ContentsOfAgent, ExpandingToMoreThanWasWantedAreRefused) {
  const Lent lent(1000);
  const Bytes larger(100'000, 7);
  const storage::Coded bomb = storage::ContentCoder().encode(larger);
  ASSERT_LT(bomb.bytes.size(), 1000U);
  Asking asking(lent);
  msg::Chunk chunk = lent.piece(0);
  chunk.data = bomb.bytes;
  chunk.total = chunk.data.size();
  EXPECT_FALSE(asking.take(chunk));
  EXPECT_EQ(asking.counted("content: cannot be expanded"), 1U);
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
  const auto order = nearest_first(window, {"marks"}, PlaceId{laid, 3}, route, 0);
  ASSERT_EQ(order.size(), 10U);
  const auto is = [&](std::size_t i, std::uint32_t index) {
    return order[i].hash == window.place({laid, index})->content.hash;
  };
  EXPECT_TRUE(is(0, 8) && is(1, 9) && is(2, 3) && is(3, 2) && is(4, 4));
}

}  // namespace
}  // namespace weft::agents::test
