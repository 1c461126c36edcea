#include <gtest/gtest.h>

#include <fstream>

#include "core/network/codec.hpp"
#include "storage/sqlite/database.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/storage/job_steps.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

/// Tests that a snapshot is restored beside itself and compared with the map.
namespace weft::storage {
namespace {

class SqliteVerify : public testing::Test {
 protected:
  void SetUp() override {
    store_ = open_sqlite(directory_.path()).value();
    ASSERT_TRUE(store_->open());
    for (int i = 0; i < 10; ++i) commit(sample::transaction(run_.next(10, 2000)));
    commit({{TakeOut{{{{run_.experience(), 40, 50}}, {}}}}});
    commit({{PutLabel{"dock", {run_.experience(), 4}},
             PutApart{{{run_.experience(), 0, 9}, {run_.experience(), 60, 69}}}}});
    live_ = store_->snapshot_at({12}, {}).value();
    ASSERT_TRUE(finish(**store_->snapshot_to(file_)));
  }
  void commit(const Transaction& transaction) {
    const auto committed = store_->commit(transaction);
    ASSERT_TRUE(committed) << committed.error().message;
  }
  Result<JobProgress> verify(const Snapshot& live) {
    auto job = store_->verify(file_, live);
    if (!job) return fail(job.error());
    return finish(**job);
  }
  /// Returns what stands beside the snapshot.
  std::vector<std::string> beside() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(elsewhere_.path())) {
      if (entry.path() != file_) names.push_back(entry.path().filename().string());
    }
    return names;
  }

  TemporaryDirectory directory_;
  TemporaryDirectory elsewhere_;
  std::filesystem::path file_ = elsewhere_.path() / "snapshot";
  std::unique_ptr<MapStore> store_;
  sample::Run run_{0x11, 1};
  Snapshot live_;
};

TEST_F(SqliteVerify, ASnapshotOfTheMapIsTheMap) {
  const auto last = verify(live_);
  ASSERT_TRUE(last) << last.error().message;
  EXPECT_TRUE(last->findings.empty()) << last->findings.front();
  EXPECT_NE(last->summary.find("89 places"), std::string::npos) << last->summary;
  EXPECT_TRUE(beside().empty()) << beside().front();
  commit({{PutLabel{"gate", {run_.experience(), 4}}}});  // the store goes on
}

TEST_F(SqliteVerify, AnotherMapIsNamedWithItsCounts) {
  const auto last = verify(with_label(live_, "gate", {run_.experience(), 1}));
  ASSERT_TRUE(last) << last.error().message;
  ASSERT_EQ(last->findings.size(), 2U);
  EXPECT_NE(last->findings[0].find("revision 12, the map is at 13"), std::string::npos) << last->findings[0];
  EXPECT_NE(last->findings[1].find("2 labels"), std::string::npos) << last->findings[1];
  EXPECT_NE(last->summary.find("do not rely on it"), std::string::npos) << last->summary;
  EXPECT_TRUE(beside().empty());
}

TEST_F(SqliteVerify, AsManyThingsThatAreOthersAreFoundByTheDigest) {
  Snapshot::Labels labels = live_.labels();
  labels.at("dock").index = 5;
  const Snapshot other(live_.revision(), live_.experiences(), std::make_shared<const Snapshot::Labels>(labels),
                       live_.shared_aparts());
  const auto last = verify(other);
  ASSERT_TRUE(last) << last.error().message;
  ASSERT_EQ(last->findings.size(), 1U);
  EXPECT_NE(last->findings[0].find("digests differ"), std::string::npos) << last->findings[0];
}

TEST_F(SqliteVerify, DamageIsNamed) {
  {
    const auto damaged = sqlite::Database::open(file_, "").value();
    ASSERT_TRUE(damaged.run("UPDATE place SET row = zeroblob(90) WHERE place = 33"));
  }
  const auto last = verify(live_);
  ASSERT_TRUE(last) << last.error().message;
  ASSERT_EQ(last->findings.size(), 2U);
  EXPECT_NE(last->findings[0].find(to_string(PlaceId{run_.experience(), 33})), std::string::npos);
  EXPECT_NE(last->findings[1].find("88 places"), std::string::npos) << last->findings[1];
  EXPECT_TRUE(beside().empty());
}

TEST_F(SqliteVerify, WhatIsNoStoreDoesNotRestore) {
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 2);
  const auto last = verify(live_);
  ASSERT_TRUE(last) << last.error().message;
  ASSERT_EQ(last->findings.size(), 1U);
  EXPECT_NE(last->findings[0].find("pages are damaged"), std::string::npos) << last->findings[0];
  std::filesystem::remove(file_);
  EXPECT_EQ(verify(live_).error().code, ErrorCode::unavailable);
  EXPECT_TRUE(beside().empty());
}

TEST_F(SqliteVerify, AJobThatIsDroppedLeavesNothing) {
  auto job = store_->verify(file_, live_).value();
  ASSERT_TRUE(job->step());
  job.reset();
  EXPECT_TRUE(beside().empty()) << beside().front();
}

TEST_F(SqliteVerify, WhatAKilledProcessLeftGoesAndNobodyElsesDoes) {
  const auto left = elsewhere_.path() / "older.verifying";
  std::filesystem::create_directory(left);
  std::ofstream(left / "lock") << "1";
  std::ofstream(left / "map.sqlite.restoring") << "half";
  const auto mine = elsewhere_.path() / "mine.verifying";
  std::filesystem::create_directory(mine);
  std::ofstream(mine / "notes") << "mine";
  ASSERT_TRUE(verify(live_));
  EXPECT_EQ(beside(), std::vector<std::string>{"mine.verifying"});
  std::filesystem::rename(mine, file_.string() + ".verifying");
  EXPECT_EQ(verify(live_).error().code, ErrorCode::conflict);
  EXPECT_TRUE(std::filesystem::exists(file_.string() + ".verifying/notes"));
}

}  // namespace
}  // namespace weft::storage
