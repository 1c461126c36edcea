#pragma once
#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "tests/contract/map_store/engines.hpp"
#include "tests/storage/job_steps.hpp"

namespace weft::storage {

/// Holds a store on an engine's medium, and what every test of the contract does with it.
class StoreTest : public testing::TestWithParam<Engine> {
 protected:
  void SetUp() override { restart(); }

  /// Restarts: the old process is gone, a new one opens the store.
  void restart() {
    store_.reset();
    auto started = medium_->start();
    ASSERT_TRUE(started) << started.error().message;
    store_ = std::move(*started);
    auto opened = store_->open();
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_TRUE(opened->quarantined.empty()) << opened->quarantined.front();
    stored_ = std::move(*opened);
  }

  Revision commit(const Transaction& transaction) {
    auto committed = store_->commit(transaction);
    EXPECT_TRUE(committed) << committed.error().message;
    return committed ? committed->revision : Revision{};
  }
  ErrorCode refusal(const Transaction& transaction) {
    auto committed = store_->commit(transaction);
    EXPECT_FALSE(committed);
    if (committed) return ErrorCode::internal;
    EXPECT_GT(committed.error().message.size(), 20U);
    return committed.error().code;
  }

  Snapshot at(std::uint64_t revision) { return at(revision, Snapshot{}); }
  Snapshot at(std::uint64_t revision, const Snapshot& near) {
    auto snapshot = store_->snapshot_at({revision}, near);
    EXPECT_TRUE(snapshot) << snapshot.error().message;
    return snapshot.value_or(Snapshot{});
  }
  RevisionChanges changes(std::uint64_t revision) {
    auto found = store_->changes_of({revision});
    EXPECT_TRUE(found) << found.error().message;
    return found.value_or(RevisionChanges{});
  }

  /// Steps a job to its end; `between` runs between two steps. Returns its last progress, with all findings.
  static JobProgress finish(
      Result<std::unique_ptr<StoreJob>> job, const std::function<void()>& between = [] {}) {
    EXPECT_TRUE(job) << job.error().message;
    if (!job) return {};
    const auto last = storage::finish(**job, between);
    EXPECT_TRUE(last) << last.error().message;
    if (!last) return {};
    EXPECT_LE(last->done, last->total);
    return *last;
  }

  std::unique_ptr<Medium> medium_ = GetParam().make_medium();
  std::unique_ptr<MapStore> store_;
  Stored stored_;
};

inline std::string engine_name(const testing::TestParamInfo<Engine>& instance) {
  return instance.param.name;
}
inline auto all_engines() {
  return testing::Values(Engine{"memory", make_memory_medium}, Engine{"sqlite", make_sqlite_medium});
}

}  // namespace weft::storage
