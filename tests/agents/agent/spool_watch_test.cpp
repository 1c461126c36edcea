#include "agents/agent/spool_watch.hpp"

#include <gtest/gtest.h>

#include "storage/spool/memory_spool.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

struct SpoolWatching : testing::Test {
  std::shared_ptr<storage::SpoolDisk> disk = std::make_shared<storage::SpoolDisk>();
  std::unique_ptr<storage::Spool> spool = storage::make_memory_spool(disk);
  SpoolWatch watch{*spool};
  SteadyTime now{10s};

  /// Ticks until the next trial was made.
  void pass_trial() {
    watch.tick(now);
    ASSERT_TRUE(watch.next());
    now = *watch.next();
    watch.tick(now);
  }
};

TEST_F(SpoolWatching, KnowsThatADiskRefusesAndThatItHasRoomAgain) {
  EXPECT_EQ(watch.refuses(), "");
  EXPECT_FALSE(watch.next());
  disk->faults.full = true;
  EXPECT_FALSE(watch.keep({.by_operator = true, .by_emergency_stop = false}));
  EXPECT_NE(watch.refuses(), "");
  pass_trial();
  EXPECT_NE(watch.refuses(), "") << "it is full still";
  disk->faults.full = false;
  watch.tick(now);
  EXPECT_NE(watch.refuses(), "") << "not each time that something happens";
  pass_trial();
  EXPECT_EQ(watch.refuses(), "");
  EXPECT_FALSE(watch.next());
}

TEST_F(SpoolWatching, WhatIsWrongWithABatchIsNotTheDisks) {
  Batch batch;
  batch.experience = {1};
  batch.sequence = 1;
  Place place;
  place.content.size = 10;
  batch.places = {place};
  const Result<void> appended = watch.append(batch, {});
  ASSERT_FALSE(appended);
  EXPECT_EQ(appended.error().code, ErrorCode::invalid);
  EXPECT_EQ(watch.refuses(), "");
}

/// Has room for small files alone.
struct Tight final : storage::Spool {
  Result<void> append(const Batch&, const std::vector<Bytes>& contents) override {
    return try_room(contents.empty() ? 0 : contents.front().size());
  }
  Result<void> replace(ExperienceId, const std::vector<Batch>&, const std::vector<Bytes>&) override { return {}; }
  Result<std::vector<Batch>> pending() const override { return std::vector<Batch>{}; }
  Result<Bytes> content(const ContentHash&) const override { return Bytes{}; }
  Result<void> acknowledged(ExperienceId, std::uint64_t) override { return {}; }
  Result<void> keep(const storage::Stops&) override { return {}; }
  storage::Stops stops() const override { return {}; }
  Result<void> try_room(std::uint64_t bytes) override {
    if (bytes > 10'000) return fail(ErrorCode::exhausted, "no room for " + std::to_string(bytes));
    return {};
  }
  std::optional<std::uint64_t> free_bytes() const override { return 20'000; }
};

TEST(SpoolWatch, ASmallFileThatFitsIsNoRoomForABatch) {
  Tight tight;
  SpoolWatch watch(tight);
  EXPECT_FALSE(watch.append({}, {Bytes(50'000)}));
  EXPECT_TRUE(watch.keep({}));
  EXPECT_NE(watch.refuses().find("no room for"), std::string::npos);
}

}  // namespace
}  // namespace weft::agents::test
