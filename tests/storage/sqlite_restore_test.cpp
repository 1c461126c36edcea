#include <gtest/gtest.h>

#include <fstream>

#include "core/network/codec.hpp"
#include "storage/sqlite/database.hpp"
#include "storage/sqlite/restore.hpp"
#include "tests/storage/job_steps.hpp"
#include "tests/storage/killed_child.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::storage {
namespace {

/// Arranges a store with a snapshot of its first ten batches, and five more.
class SqliteRestore : public testing::Test {
 protected:
  void SetUp() override {
    const auto store = open();
    for (int i = 0; i < 10; ++i) commit(*store, sample::transaction(run_.next(10, 2000)));
    finish(**store->snapshot_to(snapshot_)).value();
    old_half_ = sample::describe(store->snapshot_at({10}, {}).value());
    for (int i = 0; i < 5; ++i) commit(*store, sample::transaction(run_.next(10, 2000)));
    whole_ = sample::describe(store->snapshot_at({15}, {}).value());
  }

  std::unique_ptr<MapStore> open() {
    auto store = open_sqlite(directory_.path());
    EXPECT_TRUE(store) << store.error().message;
    auto stored = (*store)->open();
    EXPECT_TRUE(stored) << stored.error().message;
    stored_ = std::move(*stored);
    return std::move(*store);
  }
  static void commit(MapStore& store, const Transaction& transaction) {
    const auto committed = store.commit(transaction);
    ASSERT_TRUE(committed) << committed.error().message;
  }
  std::vector<std::string> map_there() {
    const auto store = open();
    EXPECT_TRUE(stored_.quarantined.empty());
    return sample::describe(stored_.snapshot);
  }
  void damage(const std::filesystem::path& file, const std::string& sql) {
    const auto database = sqlite::Database::open(file, "");
    ASSERT_TRUE(database->run(sql));
  }

  TemporaryDirectory directory_;
  TemporaryDirectory elsewhere_;
  std::filesystem::path snapshot_ = elsewhere_.path() / "half";
  sample::Run run_{0x11, 1};
  std::vector<std::string> old_half_, whole_;
  Stored stored_;
};

TEST_F(SqliteRestore, TheMapIsTheSnapshotsAndTheOldOneIsKept) {
  std::vector<std::string> stages;
  const auto restored = restore(snapshot_, directory_.path(), {.progress = [&](const RestoreProgress& at) {
                                  EXPECT_LE(at.done, at.total);
                                  if (stages.empty() || stages.back() != at.stage) stages.push_back(at.stage);
                                }});
  ASSERT_TRUE(restored) << restored.error().message;
  EXPECT_EQ(restored->revision, Revision{10});
  EXPECT_EQ(restored->epoch, Epoch{2}) << "above that of the map and of the snapshot";
  EXPECT_EQ(stages, (std::vector<std::string>{"copy", "look at pages", "check", "replace"}));
  EXPECT_EQ(map_there(), old_half_);
  EXPECT_EQ(stored_.epoch, Epoch{3});
  EXPECT_TRUE(std::filesystem::exists(snapshot_));
  ASSERT_TRUE(std::filesystem::exists(restored->kept_aside));
  ASSERT_TRUE(restore(restored->kept_aside, directory_.path())) << "and can be gone back to";
  EXPECT_EQ(map_there(), whole_);
  EXPECT_GE(stored_.epoch, Epoch{5});
}

TEST_F(SqliteRestore, AnEmptyDirectoryBecomesAStore) {
  std::filesystem::remove_all(directory_.path());
  const auto restored = restore(snapshot_, directory_.path());
  ASSERT_TRUE(restored) << restored.error().message;
  EXPECT_TRUE(restored->kept_aside.empty());
  EXPECT_EQ(map_there(), old_half_);
}

TEST_F(SqliteRestore, ADirectoryThatAServerHasOpenIsLeftAlone) {
  const auto store = open();
  const auto restored = restore(snapshot_, directory_.path());
  ASSERT_FALSE(restored);
  EXPECT_EQ(restored.error().code, ErrorCode::unavailable);
  EXPECT_NE(restored.error().message.find("stop that server"), std::string::npos);
}

TEST_F(SqliteRestore, ADamagedSnapshotReplacesNothingUnlessAccepted) {
  damage(snapshot_, "UPDATE place SET row = zeroblob(90) WHERE place = 33");
  auto restored = restore(snapshot_, directory_.path());
  ASSERT_FALSE(restored);
  EXPECT_EQ(restored.error().code, ErrorCode::corrupt);
  EXPECT_NE(restored.error().message.find("place " + to_string(PlaceId{run_.experience(), 33})), std::string::npos);
  EXPECT_EQ(map_there(), whole_);
  restored = restore(snapshot_, directory_.path(), {.accept_damage = true, .progress = {}});
  ASSERT_TRUE(restored) << restored.error().message;
  EXPECT_EQ(restored->findings.size(), 1U);
  open();
  EXPECT_EQ(stored_.snapshot.place_count(), 99U);
}

TEST_F(SqliteRestore, WhatIsNoSnapshotIsRefused) {
  const auto code = [&](const std::filesystem::path& file) {
    const auto restored = restore(file, directory_.path());
    EXPECT_FALSE(restored);
    return restored ? ErrorCode::internal : restored.error().code;
  };
  EXPECT_EQ(code(elsewhere_.path() / "none"), ErrorCode::unavailable);
  std::ofstream(elsewhere_.path() / "text") << std::string(9000, 'x');
  EXPECT_EQ(code(elsewhere_.path() / "text"), ErrorCode::corrupt);
  std::ofstream(elsewhere_.path() / "empty").flush();
  EXPECT_EQ(code(elsewhere_.path() / "empty"), ErrorCode::corrupt);
  damage(elsewhere_.path() / "other", "CREATE TABLE cookies (host TEXT)");
  EXPECT_EQ(code(elsewhere_.path() / "other"), ErrorCode::corrupt);
  std::filesystem::resize_file(snapshot_, std::filesystem::file_size(snapshot_) / 2);
  EXPECT_EQ(code(snapshot_), ErrorCode::corrupt);
  EXPECT_EQ(map_there(), whole_);
}

TEST_F(SqliteRestore, AMapThatCannotBeOpenedIsReplacedAndKept) {
  std::ofstream(directory_.path() / "map.sqlite") << std::string(9000, 'x');
  const auto restored = restore(snapshot_, directory_.path());
  ASSERT_TRUE(restored) << restored.error().message;
  EXPECT_EQ(std::filesystem::file_size(restored->kept_aside), 9000U);
  EXPECT_GT(restored->epoch.value, 1000U) << "nobody knows how many there were";
  EXPECT_EQ(map_there(), old_half_);
}

/// Stops a child dead at its first, second, ... sign of progress.
TEST_F(SqliteRestore, ACrashAtAnyMomentLeavesTheOldMapOrTheNewOne) {
  int old_maps = 0;
  for (int at = 1;; ++at) {
    const pid_t child = ::fork();
    if (child == 0) {
      int signs = 0;
      const auto restored = restore(snapshot_, directory_.path(), {.progress = [&](const RestoreProgress&) {
                                      if (++signs == at) ::_exit(7);
                                    }});
      ::_exit(restored ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    ASSERT_NE(WEXITSTATUS(status), 1) << at;
    const auto there = map_there();
    if (there == whole_) {
      ++old_maps;
    } else {
      ASSERT_EQ(there, old_half_) << at;
      if (WEXITSTATUS(status) == 0) break;
    }
  }
  EXPECT_GE(old_maps, 5);
}

}  // namespace
}  // namespace weft::storage
