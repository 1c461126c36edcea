#include "agents/agent/upload.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

struct UploadBench : Bench {
  /// Arranges a run of one place, whose content is three chunks long, in the spool.
  UploadBench() {
    Kept kept;
    kept.content = some_content(1, 3 * msg::kChunkBytes);
    kept.place = a_place(ExperienceId{1}, 0, config.self, kept.content);
    spooler.begin(ExperienceId{1}, "");
    EXPECT_TRUE(spooler.add(kept, now));
  }
  template <class M>
  std::size_t sent() {
    std::size_t count = 0;
    for (const msg::Message& message : take().send) count += std::holds_alternative<M>(message) ? 1 : 0;
    return count;
  }
  Upload upload{spooler, 2 * msg::kChunkBytes, now};
};

TEST(Upload, ContentsFollowTheirBatchWithinTheBudget) {
  UploadBench bench;
  ASSERT_TRUE(bench.spooler.flush(bench.now));
  ASSERT_TRUE(bench.upload.send_batches(bench.outbox, bench.now));
  EXPECT_EQ(bench.sent<msg::ExperienceBatch>(), 1U);
  bench.upload.send_chunks(bench.outbox, bench.now);
  EXPECT_EQ(bench.sent<msg::Chunk>(), 1U) << "one at once, and two a second";
  const std::optional<SteadyTime> next = bench.upload.next();
  ASSERT_TRUE(next.has_value());
  EXPECT_LT(*next, bench.now + 1s) << "before the batch is repeated";
  bench.upload.send_chunks(bench.outbox, *next);
  EXPECT_EQ(bench.sent<msg::Chunk>(), 1U);
}

TEST(Upload, BatchThatTheSpoolDoesNotTakeIsAnError) {
  UploadBench bench;
  bench.disk->faults.full = true;
  EXPECT_FALSE(bench.upload.send_batches(bench.outbox, bench.now + 10s));
  EXPECT_EQ(bench.sent<msg::ExperienceBatch>(), 0U);
}

TEST(Upload, NothingIsDueWithoutAnythingSpooled) {
  Bench bench;
  const Upload upload(bench.spooler, msg::kChunkBytes, bench.now);
  EXPECT_FALSE(upload.next().has_value());
}

}  // namespace
}  // namespace weft::agents::test
