#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/storage/faulty_vfs.hpp"
#include "tests/storage/job_steps.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::storage {
namespace {

class SqliteFaults : public testing::TestWithParam<FaultyVfs::Fault> {
 protected:
  Stored restart() {
    store_.reset();
    auto started = open_sqlite(directory_.path(), {vfs_.name()});
    EXPECT_TRUE(started) << started.error().message;
    store_ = std::move(*started);
    auto stored = store_->open();
    EXPECT_TRUE(stored) << stored.error().message;
    return std::move(*stored);
  }
  ErrorCode expected_code() const {
    return GetParam() == FaultyVfs::Fault::disk_full ? ErrorCode::exhausted : ErrorCode::unavailable;
  }

  FaultyVfs vfs_;
  TemporaryDirectory directory_;
  std::unique_ptr<MapStore> store_;
};

// The fault strikes at the first, second, ... write of a commit, until the commit needs no more writes than that.
TEST_P(SqliteFaults, CommitFailsAtAnyWriteAsAWholeAndWorksAgainWhenTheDiskDoes) {
  sample::Run run(1, 1);
  restart();
  ASSERT_TRUE(store_->commit(sample::transaction(run.next(2))));
  const auto second = run.next(4, 3000);
  const Transaction transaction = sample::transaction(second);
  int struck = 0;
  for (int writes = 0;; ++writes) {
    const auto before = sample::describe(restart());
    vfs_.fail_after(writes, GetParam());
    const auto committed = store_->commit(transaction);
    vfs_.heal();
    if (committed) {
      EXPECT_EQ(committed->revision, Revision{2});
      break;
    }
    ++struck;
    EXPECT_EQ(committed.error().code, expected_code()) << committed.error().message;
    EXPECT_FALSE(store_->has_content(second.batch.places.front().content.hash));
    EXPECT_EQ(store_->batch_hash({1}, 2), std::nullopt);
    EXPECT_EQ(store_->size().contents, 2U);
    ASSERT_EQ(sample::describe(restart()), before) << "after " << writes << " writes";
  }
  EXPECT_GE(struck, 3) << "the fault must hit pages and the sync";
  EXPECT_EQ(restart().snapshot.place_count(), 6U);
}

TEST_P(SqliteFaults, FullDiskStopsCommitsServesReadsAndResumesWithoutRestart) {
  sample::Run run(1, 1);
  restart();
  const auto first = run.next(3);
  ASSERT_TRUE(store_->commit(sample::transaction(first)));
  const auto second = run.next(3);
  vfs_.fail_after(0, GetParam());
  for (int attempt = 0; attempt < 5; ++attempt) {
    const auto committed = store_->commit(sample::transaction(second));
    ASSERT_FALSE(committed);
    EXPECT_EQ(committed.error().code, expected_code());
    const auto read = store_->content(first.batch.places.front().content.hash);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, first.contents.front());
  }
  vfs_.heal();
  const auto committed = store_->commit(sample::transaction(second));
  ASSERT_TRUE(committed) << committed.error().message;
  EXPECT_EQ(committed->revision, Revision{2});
  const auto job = store_->check();
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_TRUE(finish(**job)->findings.empty());
  EXPECT_EQ(restart().snapshot.place_count(), 6U);
  for (const Bytes& bytes : second.contents) EXPECT_EQ(store_->content(hash_bytes(bytes)).value(), bytes);
}

// What happens on a disk that fills up in the middle of a day: some commits, space for a while, full again.
TEST_P(SqliteFaults, SpaceThatComesAndGoesLosesNothing) {
  sample::Run run(1, 1);
  restart();
  Random random(9);
  std::uint64_t refused = 0;
  for (std::uint64_t batch = 1; batch <= 40; ++batch) {
    const auto delivery = run.next(2, 2500);
    vfs_.fail_after(static_cast<int>(random.below(30)), GetParam());
    for (bool is_in = false; !is_in;) {
      const auto committed = store_->commit(sample::transaction(delivery));
      is_in = committed.has_value();
      if (is_in) {
        EXPECT_EQ(committed->revision, Revision{batch});
      } else {
        ++refused;
        EXPECT_EQ(committed.error().code, expected_code());
        EXPECT_TRUE(store_->log({}, 3)) << "reads are served";
        vfs_.heal();
      }
    }
  }
  vfs_.heal();
  EXPECT_GT(refused, 10U);
  EXPECT_TRUE(finish(**store_->check())->findings.empty());
  const Stored stored = restart();
  EXPECT_EQ(stored.snapshot.place_count(), 80U);
  EXPECT_EQ(stored.durable_through.at({1}), 40U);
}

TEST_P(SqliteFaults, OpeningOnAFaultyDiskNamesTheReason) {
  restart();
  store_.reset();
  vfs_.fail_after(0, GetParam());
  auto started = open_sqlite(directory_.path(), {vfs_.name()});
  Error error;
  if (!started) {
    error = started.error();
  } else {
    const auto opened = (*started)->open();
    ASSERT_FALSE(opened);
    error = opened.error();
  }
  EXPECT_EQ(error.code, expected_code()) << error.message;
  EXPECT_NE(error.message.find("map.sqlite"), std::string::npos) << error.message;
}

INSTANTIATE_TEST_SUITE_P(Faults, SqliteFaults,
                         testing::Values(FaultyVfs::Fault::disk_full, FaultyVfs::Fault::io_error),
                         [](const auto& instance) {
                           return instance.param == FaultyVfs::Fault::disk_full ? "disk_full" : "io_error";
                         });

}  // namespace
}  // namespace weft::storage
