#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "storage/sqlite/sqlite_store.hpp"
#include "tests/storage/job_steps.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

/// Tests that the log of a store is emptied aside, while others commit and read.
namespace weft::storage {
namespace {

using namespace std::chrono_literals;

class Aside : public testing::Test {
 protected:
  void SetUp() override {
    auto started = open_sqlite(directory_.path(), {.empties_log_aside = true});
    ASSERT_TRUE(started) << started.error().message;
    store_ = std::move(*started);
    ASSERT_TRUE(store_->open());
  }
  void commit(std::uint32_t places) {
    const auto done = store_->commit(sample::transaction(run_.next(places, 20'000)));
    ASSERT_TRUE(done) << done.error().message;
  }
  std::uintmax_t size_of(const char* name) const { return std::filesystem::file_size(directory_.path() / name); }

  TemporaryDirectory directory_;
  std::unique_ptr<MapStore> store_;
  sample::Run run_{1, 1};
};

TEST_F(Aside, TheFileGrowsThoughNobodyCommitsAnyMore) {
  const std::uintmax_t before = size_of("map.sqlite");
  for (int i = 0; i < 30; ++i) commit(20);
  const auto end = std::chrono::steady_clock::now() + 60s;
  while (size_of("map.sqlite") < before + 3'000'000 && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_GE(size_of("map.sqlite"), before + 3'000'000);
}

TEST_F(Aside, TheLogStaysShortUnderCommits) {
  for (int i = 0; i < 400; ++i) commit(20);
  EXPECT_LT(size_of("map.sqlite-wal"), 100'000'000U) << "some 140 MB went through it";
}

TEST_F(Aside, WhatIsCommittedMeanwhileIsThere) {
  for (int i = 0; i < 100; ++i) {
    commit(10);
    if (i % 25 != 0) continue;
    EXPECT_TRUE(finish(*store_->check().value()));
  }
  const auto expected = sample::describe(store_->snapshot_at({100}, {}).value());
  store_.reset();
  const auto again = open_sqlite(directory_.path(), {.empties_log_aside = true});
  ASSERT_TRUE(again);
  EXPECT_EQ(sample::describe((*again)->open()->snapshot), expected);
  const auto checked = finish(*(*again)->check().value());
  ASSERT_TRUE(checked);
  EXPECT_TRUE(checked->findings.empty());
}

}  // namespace
}  // namespace weft::storage
