#include "agents/agent/chunks.hpp"

#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

msg::Chunk piece(const Bytes& bytes, std::uint64_t offset, std::uint64_t size) {
  msg::Chunk chunk;
  chunk.hash = hash_bytes(bytes);
  chunk.total = bytes.size();
  chunk.offset = offset;
  chunk.data.assign(bytes.begin() + static_cast<std::ptrdiff_t>(offset),
                    bytes.begin() + static_cast<std::ptrdiff_t>(offset + size));
  return chunk;
}

TEST(Assembly, AnyOrderOverlapAndRepeatsGiveTheBytes) {
  const Bytes bytes = some_content(1, 1000);
  Assembly assembly(1000);
  ASSERT_TRUE(assembly.add(piece(bytes, 600, 400)).has_value());
  EXPECT_EQ(assembly.contiguous(), 0U);
  ASSERT_TRUE(assembly.add(piece(bytes, 0, 300)).has_value());
  ASSERT_TRUE(assembly.add(piece(bytes, 0, 300)).has_value());
  EXPECT_EQ(assembly.contiguous(), 300U);
  EXPECT_FALSE(assembly.complete());
  ASSERT_TRUE(assembly.add(piece(bytes, 200, 500)).has_value());
  ASSERT_TRUE(assembly.complete());
  EXPECT_EQ(assembly.bytes(), bytes);
}

TEST(Assembly, ChunkBeyondTheContentIsRefused) {
  const Bytes bytes = some_content(1, 1000);
  Assembly assembly(900);
  EXPECT_EQ(assembly.add(piece(bytes, 0, 100)).error().code, ErrorCode::invalid);
  msg::Chunk beyond = piece(bytes, 900, 100);
  beyond.total = 900;
  EXPECT_FALSE(assembly.add(beyond).has_value());
  EXPECT_EQ(assembly.contiguous(), 0U);
}

TEST(Assembly, ChunkOfAnotherFormIsRefused) {
  const Bytes bytes = some_content(1, 100);
  Assembly assembly(100, msg::Coding::zstd);
  msg::Chunk chunk = piece(bytes, 0, 100);
  EXPECT_FALSE(assembly.is_of(chunk));
  EXPECT_EQ(assembly.add(chunk).error().code, ErrorCode::invalid);
  chunk.coding = msg::Coding::zstd;
  EXPECT_TRUE(assembly.is_of(chunk));
  EXPECT_TRUE(assembly.add(chunk));
}

TEST(ChunkQueue, KeepsToItsBudgetAndPutsTheContentOutWhole) {
  const Bytes bytes = some_content(3, 5 * msg::kChunkBytes + 17);
  const ContentHash hash = hash_bytes(bytes);
  SteadyTime now{};
  Budget budget(4 * msg::kChunkBytes, 2 * msg::kChunkBytes, now);
  ChunkQueue queue;
  queue.push(hash, 0, now);
  queue.push(hash, 0, now);
  Assembly assembly(bytes.size());
  std::uint64_t sent = 0;
  while (!queue.empty()) {
    const auto chunk = queue.next(
        budget, [&](const ContentHash&) { return Result<Bytes>(bytes); }, now);
    ASSERT_TRUE(chunk.has_value());
    if (!chunk->has_value()) {
      now += 10ms;
      continue;
    }
    sent += (*chunk)->data.size();
    ASSERT_TRUE(assembly.add(**chunk).has_value());
    EXPECT_LE(static_cast<double>(sent),
              2.0 * msg::kChunkBytes + 4.0 * msg::kChunkBytes * seconds(now.time_since_epoch()) + 1);
  }
  EXPECT_EQ(sent, bytes.size());
  EXPECT_TRUE(assembly.complete());
  EXPECT_EQ(assembly.bytes(), bytes);
  EXPECT_GE(seconds(now.time_since_epoch()), 0.7);
}

TEST(ChunkQueue, AskedAgainWhileUnderWayIsSentOnce) {
  const Bytes bytes = some_content(3, 10);
  const SteadyTime now{};
  Budget budget(msg::kChunkBytes, msg::kChunkBytes, now);
  ChunkQueue queue;
  const ChunkQueue::Read read = [&](const ContentHash&) { return Result<Bytes>(bytes); };
  queue.push(hash_bytes(bytes), 0, now);
  ASSERT_TRUE(queue.next(budget, read, now)->has_value());
  queue.push(hash_bytes(bytes), 0, now + 100ms);
  EXPECT_TRUE(queue.empty());
  queue.push(hash_bytes(bytes), 4, now + 2s);
  const auto again = queue.next(budget, read, now + 2s);
  ASSERT_TRUE(again->has_value());
  EXPECT_EQ((*again)->offset, 4U);
  EXPECT_EQ((*again)->data.size(), 6U);
}

TEST(Budget, SaysWhenThereWillBeEnough) {
  const SteadyTime now{};
  Budget budget(1000, 500, now);
  EXPECT_TRUE(budget.take(500, now));
  EXPECT_FALSE(budget.take(1, now));
  const SteadyTime then = budget.when(250);
  EXPECT_NEAR(seconds(then - now), 0.25, 1e-6);
  EXPECT_TRUE(budget.take(250, then));
}

}  // namespace
}  // namespace weft::agents::test
