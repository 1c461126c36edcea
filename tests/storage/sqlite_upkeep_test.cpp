#include <gtest/gtest.h>

#include <fstream>

#include "core/network/codec.hpp"
#include "storage/sqlite/database.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/storage/faulty_vfs.hpp"
#include "tests/storage/job_steps.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

/// Tests what only a store on a disk can show: damage under a check, and snapshots as files.
namespace weft::storage {
namespace {

class SqliteUpkeep : public testing::Test {
 protected:
  void SetUp() override {
    start();
    for (int i = 0; i < 30; ++i) deliveries_.push_back(run_.next(10, 2000));
    for (const auto& delivery : deliveries_) commit(sample::transaction(delivery));
    auto joined = other_.next(5);
    joined.batch.edges.push_back(sample::stitch({run_.experience(), 3}, {other_.experience(), 1}));
    commit(sample::transaction(joined));
    commit({{PutLabel{"dock", {run_.experience(), 4}}, PutGoal{sample::goal(1, {run_.experience(), 4})},
             PutRoute{sample::route(1, {run_.experience(), 4}, {run_.experience(), 5})},
             PutPreparation{"marks", Bytes(1000, 7)}}});
    commit({{TakeOut{{{{run_.experience(), 50, 60}}, {joined.batch.edges.back().id}}}}});
  }

  Stored start() { return start(directory_.path()); }
  Stored start(const std::filesystem::path& directory) {
    store_.reset();
    auto started = open_sqlite(directory, {vfs_.name()});
    EXPECT_TRUE(started) << started.error().message;
    store_ = std::move(*started);
    auto stored = store_->open();
    EXPECT_TRUE(stored) << stored.error().message;
    return std::move(*stored);
  }
  void commit(const Transaction& transaction) {
    const auto committed = store_->commit(transaction);
    ASSERT_TRUE(committed) << committed.error().message;
  }

  /// Damages the file by SQL and checks it; expects exactly one finding, with `named` in it.
  void expect_found(const std::string& sql, const std::string& named) {
    store_.reset();
    {
      const auto database = sqlite::Database::open(directory_.path() / "map.sqlite", "");
      ASSERT_TRUE(database);
      const auto done = database->run(sql);
      ASSERT_TRUE(done) << done.error().message;
      ASSERT_GT(database->number("SELECT changes()").value(), 0U) << sql;
    }
    start();
    const auto job = store_->check();
    ASSERT_TRUE(job);
    const auto progress = finish(**job);
    ASSERT_TRUE(progress) << progress.error().message;
    ASSERT_EQ(progress->findings.size(), 1U) << sql << testing::PrintToString(progress->findings);
    EXPECT_NE(progress->findings[0].find(named), std::string::npos) << progress->findings[0];
    EXPECT_NE(progress->summary.find("1 found damaged"), std::string::npos) << progress->summary;
  }

  FaultyVfs vfs_;
  TemporaryDirectory directory_;
  TemporaryDirectory elsewhere_;
  std::unique_ptr<MapStore> store_;
  sample::Run run_{0x11, 1};
  sample::Run other_{0x22, 2};
  std::vector<sample::Delivery> deliveries_;
};

TEST_F(SqliteUpkeep, CheckQuarantinesADamagedContent) {
  const ContentHash hash = deliveries_[7].batch.places[3].content.hash;
  expect_found("UPDATE content SET bytes = substr(bytes, 1, 900) || x'ffff' || substr(bytes, 903) WHERE hash = x'" +
                   to_string(hash) + "'",
               "content " + to_string(hash));
  EXPECT_FALSE(store_->has_content(hash));
  commit({{PutContent{hash, msg::ContentKind::content, deliveries_[7].contents[3]}}});
  EXPECT_TRUE(finish(**store_->check())->findings.empty());
}

TEST_F(SqliteUpkeep, CheckNamesAnImpossibleSize) {
  const ContentHash hash = deliveries_[0].batch.places[0].content.hash;
  expect_found("UPDATE content SET size = -1 WHERE hash = x'" + to_string(hash) + "'", "content " + to_string(hash));
}

TEST_F(SqliteUpkeep, CheckNamesASumThatDiffers) {
  const ContentHash hash = deliveries_[0].batch.places[0].content.hash;
  expect_found("UPDATE content SET sum = sum + 1 WHERE hash = x'" + to_string(hash) + "'",
               "content " + to_string(hash) + ": its sum differs");
}
TEST_F(SqliteUpkeep, CheckNamesAMissingContentOfAPlace) {
  expect_found("DELETE FROM content WHERE hash = x'" + to_string(deliveries_[2].batch.places[1].content.hash) + "'",
               "place " + to_string(PlaceId{run_.experience(), 21}));
}
TEST_F(SqliteUpkeep, CheckNamesADamagedPlace) {
  expect_found("UPDATE place SET row = zeroblob(90) WHERE experience = 17 AND place = 33",
               "place " + to_string(PlaceId{run_.experience(), 33}));
}
TEST_F(SqliteUpkeep, CheckNamesMissingLastPlaces) {
  expect_found("UPDATE experience SET places = 302 WHERE id = 17",
               "experience " + to_string(run_.experience()) + ": it says 302 places");
}
TEST_F(SqliteUpkeep, CheckNamesAMissingHop) {
  expect_found("DELETE FROM edge WHERE a_experience = 17 AND a_place = 70",
               "edge " + to_string(PlaceId{run_.experience(), 70}));
}
TEST_F(SqliteUpkeep, CheckNamesADamagedStitch) {
  expect_found(
      "UPDATE edge SET row = substr(row, 1, 40) || x'77' || substr(row, 42) WHERE b_experience = 34 AND"
      " a_experience = 17",
      "edge " + to_string(PlaceId{run_.experience(), 3}));
}
TEST_F(SqliteUpkeep, CheckNamesALabelOfNoPlace) {
  expect_found("UPDATE label SET place = 4000", "label dock");
}
TEST_F(SqliteUpkeep, CheckNamesADamagedRule) {
  commit({{PutRule{{.name = "shut", .label = "dock"}}}});
  expect_found("UPDATE rule SET row = zeroblob(length(row))", "rule shut");
}
TEST_F(SqliteUpkeep, CheckNamesDamagedPasses) {
  commit({{PutPasses{{run_.experience(), 3, false}, {{8.0, 16.0, 0.0}}}}});
  expect_found("UPDATE passes SET row = zeroblob(length(row))",
               "passes of piece 3 of experience " + to_string(run_.experience()) + ", backward");
}
TEST_F(SqliteUpkeep, CheckNamesADamagedAwaitedLabel) {
  commit({{PutAwaitedLabel{.label = "gate", .place = {run_.experience(), 999}, .robot = sample::robot(1)}}});
  expect_found("UPDATE awaited_label SET robot = x'0102'", "awaited_label gate: the id of its robot");
}
TEST_F(SqliteUpkeep, CheckNamesAnAwaitedLabelOfNoPlace) {
  commit({{PutAwaitedLabel{.label = "gate", .place = {run_.experience(), 999}, .robot = sample::robot(1)}}});
  expect_found("UPDATE awaited_label SET experience = 0", "awaited_label gate: it names no label or no place");
}
TEST_F(SqliteUpkeep, CheckNamesARuleOfAnotherName) {
  commit({{PutRule{{.name = "shut", .label = "dock"}}}});
  expect_found("UPDATE rule SET name = 'other'", "rule other: the row of another rule");
}
TEST_F(SqliteUpkeep, CheckNamesADamagedRegistration) {
  commit({{PutRegistration{{.plan = "hall"}}}});
  expect_found("UPDATE registration SET row = zeroblob(length(row))", "registration of plan hall");
}
TEST_F(SqliteUpkeep, CheckNamesARegistrationOfAnotherPlan) {
  commit({{PutRegistration{{.plan = "hall"}}}});
  expect_found("UPDATE registration SET plan = 'yard'", "registration of plan yard: the row of another plan");
}
TEST_F(SqliteUpkeep, CheckNamesAMissingBatch) {
  expect_found("DELETE FROM batch WHERE experience = 17 AND sequence = 12", "batch 13 of experience");
}
TEST_F(SqliteUpkeep, CheckNamesAMissingLastBatch) {
  expect_found("DELETE FROM batch WHERE experience = 17 AND sequence = 30", "durable through batch 30");
}
TEST_F(SqliteUpkeep, CheckNamesMissingRevisions) {
  expect_found("DELETE FROM revision WHERE id = 9", "revision 9");
}
TEST_F(SqliteUpkeep, CheckNamesMissingLastRevisions) {
  expect_found("DELETE FROM revision WHERE id > 31", "revision 32 to 33");
}
TEST_F(SqliteUpkeep, CheckNamesMovesOfNothing) {
  expect_found("UPDATE moved_places SET last_place = 900", "moved_places 33");
  expect_found("UPDATE moved_places SET last_place = 60; UPDATE moved_stitch SET b_place = 4", "moved_stitch 33");
}
TEST_F(SqliteUpkeep, CheckNamesDamagedGoalsAndRoutes) {
  expect_found("UPDATE goal SET row = zeroblob(50)", "goal " + to_string(sample::goal_id(1)));
  expect_found("DELETE FROM goal; UPDATE route SET row = zeroblob(50)", "route " + to_string(sample::goal_id(1)));
}
TEST_F(SqliteUpkeep, CheckNamesADamagedPreparationAndReadingItSaysSo) {
  expect_found("UPDATE preparation SET bytes = zeroblob(1000)", "preparation marks");
  EXPECT_EQ(store_->preparation("marks").error().code, ErrorCode::corrupt);
}

TEST_F(SqliteUpkeep, CompactionGivesSpaceBack) {
  commit({{TakeOut{{{{run_.experience(), 0, 289}}, {}}}}});
  start();
  const auto file = directory_.path() / "map.sqlite";
  const auto before = std::filesystem::file_size(file);
  const auto job = store_->compact({34});
  ASSERT_TRUE(job) << job.error().message;
  const auto progress = finish(**job);
  ASSERT_TRUE(progress) << progress.error().message;
  EXPECT_LT(std::filesystem::file_size(file), before / 2) << progress->summary;
  EXPECT_EQ(std::filesystem::file_size(directory_.path() / "map.sqlite-wal"), 0U);
  EXPECT_TRUE(finish(**store_->check())->findings.empty());
  EXPECT_EQ(store_->compact({34}).error().code, ErrorCode::unavailable) << "the job is still there";
}

TEST_F(SqliteUpkeep, CompactionStopsOnAFullDiskAndGoesOnLater) {
  commit({{TakeOut{{{{run_.experience(), 0, 289}}, {}}}}});
  const auto expected = sample::describe(store_->snapshot_at({34}, {}).value());
  int stopped = 0;
  for (int writes = 0;; writes += 40) {
    vfs_.fail_after(writes, FaultyVfs::Fault::disk_full);
    const auto job = store_->compact({34});
    const auto progress = job ? finish(**job) : Result<JobProgress>(fail(job.error()));
    vfs_.heal();
    EXPECT_EQ(sample::describe(store_->snapshot_at({34}, {}).value()), expected);
    if (progress) break;
    ++stopped;
    EXPECT_EQ(progress.error().code, ErrorCode::exhausted) << progress.error().message;
  }
  EXPECT_GE(stopped, 2);
  EXPECT_TRUE(finish(**store_->check())->findings.empty());
  EXPECT_EQ(store_->size().contents, 15U);
}

TEST_F(SqliteUpkeep, SnapshotCarriesCommitsBetweenItsStepsAndOpensAsAStore) {
  commit({{PutPreparation{"large", Bytes(4'000'000, 9)}}});
  const auto file = elsewhere_.path() / "map.sqlite";
  auto job = store_->snapshot_to(file);
  ASSERT_TRUE(job) << job.error().message;
  int commits = 0;
  const auto progress = finish(**job, [&] {
    if (++commits < 4) commit(sample::transaction(run_.next(20, 3000)));
  });
  ASSERT_TRUE(progress) << progress.error().message;
  EXPECT_GE(commits, 1) << "it took one step: nothing is shown";
  job->reset();
  const auto expected = sample::describe(start());
  EXPECT_EQ(sample::describe(start(elsewhere_.path())), expected);
  EXPECT_TRUE(finish(**store_->check())->findings.empty());
  EXPECT_FALSE(std::filesystem::exists(elsewhere_.path() / "map.sqlite.part"));
}

TEST_F(SqliteUpkeep, SnapshotThatIsDroppedLeavesNothing) {
  commit({{PutPreparation{"large", Bytes(4'000'000, 9)}}});
  {
    auto job = store_->snapshot_to(elsewhere_.path() / "dropped");
    ASSERT_TRUE((*job)->step());
  }
  EXPECT_TRUE(std::filesystem::is_empty(elsewhere_.path()));
}

TEST_F(SqliteUpkeep, SnapshotToABadPathSaysSo) {
  const auto nowhere = store_->snapshot_to(elsewhere_.path() / "none" / "file");
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, ErrorCode::unavailable);
  EXPECT_NE(nowhere.error().message.find("none/file"), std::string::npos) << nowhere.error().message;
}

TEST_F(SqliteUpkeep, SnapshotOnAFullDiskLeavesNothingAndTheStoreGoesOn) {
  for (const int writes : {0, 3, 60}) {
    const auto file = elsewhere_.path() / "full";
    vfs_.fail_after(writes, FaultyVfs::Fault::disk_full);
    auto job = store_->snapshot_to(file);
    const auto progress = job ? finish(**job) : Result<JobProgress>(fail(job.error()));
    vfs_.heal();
    ASSERT_FALSE(progress) << writes;
    EXPECT_EQ(progress.error().code, ErrorCode::exhausted) << progress.error().message;
    if (job) job->reset();
    EXPECT_TRUE(std::filesystem::is_empty(elsewhere_.path()));
    commit(sample::transaction(run_.next(2)));
  }
}

}  // namespace
}  // namespace weft::storage
