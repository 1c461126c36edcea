#include <gtest/gtest.h>

#include "storage/memory/memory_store.hpp"
#include "storage/spool/memory_spool.hpp"
#include "tests/storage/sample_map.hpp"

namespace weft::storage {
namespace {

class MemoryFaults : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(store_->open()); }
  ErrorCode refusal(const Transaction& transaction) {
    const auto committed = store_->commit(transaction);
    EXPECT_FALSE(committed);
    return committed ? ErrorCode::internal : committed.error().code;
  }
  std::shared_ptr<MemoryDisk> disk_ = std::make_shared<MemoryDisk>();
  std::unique_ptr<MapStore> store_ = make_memory_store(disk_);
  sample::Run run_{1, 1};
};

TEST_F(MemoryFaults, NextCommitsFailWithTheGivenCodeAndLeaveNothing) {
  const auto transaction = sample::transaction(run_.next(2));
  disk_->faults.fail_next = 2;
  EXPECT_EQ(refusal(transaction), ErrorCode::unavailable);
  disk_->faults.fail_with = ErrorCode::exhausted;
  EXPECT_EQ(refusal(transaction), ErrorCode::exhausted);
  EXPECT_EQ(disk_->faults.struck, 2U);
  EXPECT_TRUE(disk_->contents.empty());
  EXPECT_TRUE(disk_->history.empty());
  EXPECT_EQ(store_->commit(transaction)->revision, Revision{1});
}

TEST_F(MemoryFaults, FullDiskLastsUntilThereIsSpace) {
  const auto first = run_.next(2);
  ASSERT_TRUE(store_->commit(sample::transaction(first)));
  const auto transaction = sample::transaction(run_.next(2));
  disk_->faults.full = true;
  for (int attempt = 0; attempt < 3; ++attempt) EXPECT_EQ(refusal(transaction), ErrorCode::exhausted);
  EXPECT_TRUE(store_->content(first.batch.places[0].content.hash));
  EXPECT_EQ(store_->size().disk_free_bytes, 0U);
  EXPECT_FALSE(make_memory_store(disk_)->open());
  disk_->faults.full = false;
  EXPECT_TRUE(store_->commit(transaction));
}

TEST_F(MemoryFaults, TornCommitLeavesNothingForTheNextOpening) {
  const auto transaction = sample::transaction(run_.next(2));
  disk_->faults.tear_next = true;
  EXPECT_EQ(refusal(transaction), ErrorCode::unavailable);
  store_ = make_memory_store(disk_);
  const auto stored = store_->open();
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->snapshot.place_count(), 0U);
  EXPECT_TRUE(store_->commit(transaction));
}

TEST_F(MemoryFaults, CopyOfADiskIsABackup) {
  ASSERT_TRUE(store_->commit(sample::transaction(run_.next(2))));
  const auto backup = std::make_shared<MemoryDisk>(*disk_);
  ASSERT_TRUE(store_->commit(sample::transaction(run_.next(2))));
  EXPECT_EQ(make_memory_store(backup)->open()->snapshot.place_count(), 2U);
  EXPECT_EQ(make_memory_store(disk_)->open()->snapshot.place_count(), 4U);
}

TEST(MemorySpoolFaults, FailedAppendLeavesNothing) {
  const auto disk = std::make_shared<SpoolDisk>();
  const auto spool = make_memory_spool(disk);
  const auto delivery = sample::Run(1, 1).next(2);
  disk->faults.full = true;
  const auto appended = spool->append(delivery.batch, delivery.contents);
  ASSERT_FALSE(appended);
  EXPECT_EQ(appended.error().code, ErrorCode::exhausted);
  EXPECT_TRUE(spool->pending()->empty());
  disk->faults.full = false;
  EXPECT_TRUE(spool->append(delivery.batch, delivery.contents));
}

}  // namespace
}  // namespace weft::storage
