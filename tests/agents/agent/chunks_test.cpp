#include "agents/agent/chunks.hpp"

#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "core/protocol/assembly.hpp"
#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

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
  EXPECT_TRUE(assembly.is_complete());
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
