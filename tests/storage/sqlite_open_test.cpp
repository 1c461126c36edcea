#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "storage/sqlite/database.hpp"
#include "storage/sqlite/schema.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::storage {
namespace {

Error opening_error(const std::filesystem::path& directory) {
  const auto store = open_sqlite(directory);
  EXPECT_FALSE(store);
  return store ? Error{} : store.error();
}

void run_sql(const std::filesystem::path& file, const std::string& sql) {
  const auto database = sqlite::Database::open(file, "");
  ASSERT_TRUE(database) << database.error().message;
  const auto done = database->run(sql);
  ASSERT_TRUE(done) << done.error().message;
}

TEST(SqliteOpen, NewerStoreIsRefusedNamingBothVersions) {
  const TemporaryDirectory directory;
  ASSERT_TRUE(open_sqlite(directory.path()));
  run_sql(directory.path() / "map.sqlite", "PRAGMA user_version = 77");
  const Error error = opening_error(directory.path());
  EXPECT_EQ(error.code, ErrorCode::newer);
  EXPECT_NE(error.message.find("version 77"), std::string::npos) << error.message;
  EXPECT_NE(error.message.find("up to " + std::to_string(sqlite::schema_version())), std::string::npos);
}

TEST(SqliteOpen, FileThatIsNoDatabaseIsCorruptAndSaysWhatToDo) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "map.sqlite") << std::string(5000, 'x');
  const Error error = opening_error(directory.path());
  EXPECT_EQ(error.code, ErrorCode::corrupt);
  EXPECT_NE(error.message.find("move this file away"), std::string::npos) << error.message;
}

TEST(SqliteOpen, DatabaseOfAnotherProgramIsCorruptAndLeftAlone) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "map.sqlite";
  run_sql(file, "CREATE TABLE cookies (host TEXT)");
  EXPECT_EQ(opening_error(directory.path()).code, ErrorCode::corrupt);
  run_sql(file, "PRAGMA application_id = 1234");
  EXPECT_EQ(opening_error(directory.path()).code, ErrorCode::corrupt);
  run_sql(file, "INSERT INTO cookies VALUES ('still here')");
}

TEST(SqliteOpen, EmptyFileIsAStoreToBe) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "map.sqlite").flush();
  const auto store = open_sqlite(directory.path());
  ASSERT_TRUE(store) << store.error().message;
  EXPECT_TRUE((*store)->open());
}

TEST(SqliteOpen, UnusableDirectoryIsUnavailable) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "file") << "no directory";
  EXPECT_EQ(opening_error(directory.path() / "file").code, ErrorCode::unavailable);
  EXPECT_EQ(opening_error(directory.path() / "file" / "below").code, ErrorCode::unavailable);
}

TEST(SqliteOpen, EveryCommitIsSynchronisedInWal) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "map.sqlite";
  const auto database = sqlite::Database::open(file, "");
  ASSERT_TRUE(database);
  ASSERT_TRUE(sqlite::prepare_schema(*database, file));
  EXPECT_EQ(database->number("PRAGMA synchronous").value(), 2U);
  EXPECT_EQ(database->number("SELECT journal_mode = 'wal' FROM pragma_journal_mode").value(), 1U);
  EXPECT_EQ(database->number("PRAGMA application_id").value(), sqlite::kApplicationId);
  EXPECT_EQ(database->number("PRAGMA user_version").value(), sqlite::schema_version());
}

TEST(SqliteOpen, AStoreOfTheFirstSchemaIsMigratedAndItsRevisionsAreNoted) {
  const TemporaryDirectory directory;
  sample::Run run(0x11, 1);
  {
    const auto store = open_sqlite(directory.path());
    ASSERT_TRUE((*store)->open());
    ASSERT_TRUE((*store)->commit(sample::transaction(run.next(3))));
    ASSERT_TRUE((*store)->commit({{PutLabel{"dock", {run.experience(), 1}}}, {}}));
  }
  run_sql(directory.path() / "map.sqlite",
          "DROP TABLE registration; DROP TABLE rule; DROP TABLE hold; DROP TABLE awaited_label; DROP TABLE passes; "
          "DROP TABLE apart; DROP "
          "TABLE place_anew; DROP INDEX "
          "edge_by_b; DROP "
          "TABLE revision; DROP TABLE "
          "moved_places; DROP TABLE "
          "moved_stitch;"
          "DROP TABLE deleted_places; DROP TABLE preparation; ALTER TABLE store DROP COLUMN floor;"
          "ALTER TABLE content DROP COLUMN sum; PRAGMA user_version = 1");
  const auto store = open_sqlite(directory.path());
  ASSERT_TRUE(store) << store.error().message;
  const auto stored = (*store)->open();
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->snapshot.place_count(), 3U);
  EXPECT_EQ((*store)->log({}, 10)->size(), 2U);
  EXPECT_EQ((*store)->snapshot_at({1}, {})->labels().size(), 0U);
  EXPECT_EQ((*store)->commit({{RollBack{{1}}}, {}})->revision, Revision{3});
  EXPECT_EQ((*store)->snapshot_at({3}, {})->place_count(), 3U);
}

TEST(SqliteOpen, AStoreOfTheSecondSchemaIsMigratedAndKeepsItsPast) {
  const TemporaryDirectory directory;
  sample::Run run(0x11, 1);
  std::vector<std::string> before;
  {
    const auto store = open_sqlite(directory.path());
    ASSERT_TRUE((*store)->open());
    ASSERT_TRUE((*store)->commit(sample::transaction(run.next(3))));
    ASSERT_TRUE((*store)->commit({{TakeOut{{{{run.experience(), 1, 1}}, {}}}}, {}}));
    before = sample::describe((*store)->snapshot_at({1}, {}).value());
  }
  run_sql(directory.path() / "map.sqlite",
          "DROP TABLE registration; DROP TABLE rule; DROP TABLE hold; DROP TABLE awaited_label; DROP TABLE passes; "
          "DROP TABLE apart; DROP "
          "TABLE place_anew; DROP INDEX "
          "edge_by_b; DROP "
          "TABLE deleted_places; DROP TABLE "
          "preparation;"
          "ALTER TABLE store DROP COLUMN floor; ALTER TABLE content DROP COLUMN sum; PRAGMA user_version = 2");
  const auto store = open_sqlite(directory.path());
  ASSERT_TRUE(store) << store.error().message;
  const auto stored = (*store)->open();
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->snapshot.place_count(), 2U);
  EXPECT_EQ(sample::describe((*store)->snapshot_at({1}, {}).value()), before);
  ASSERT_TRUE((*store)->commit({{PutPreparation{"marks", {1, 2, 3}}}, {}}));
  EXPECT_EQ((*store)->preparation("marks").value(), (Bytes{1, 2, 3}));
}

TEST(SqliteOpen, AStoreOfTheThirdSchemaIsMigratedAndItsContentsAreServed) {
  const TemporaryDirectory directory;
  const auto delivery = sample::Run(0x11, 1).next(2);
  const ContentHash hash = delivery.batch.places[0].content.hash;
  {
    const auto store = open_sqlite(directory.path());
    ASSERT_TRUE((*store)->open());
    ASSERT_TRUE((*store)->commit(sample::transaction(delivery)));
  }
  run_sql(directory.path() / "map.sqlite",
          "DROP TABLE registration; DROP TABLE rule; DROP TABLE hold; DROP TABLE awaited_label; DROP TABLE passes; "
          "DROP TABLE apart; DROP "
          "TABLE place_anew; DROP INDEX "
          "edge_by_b; ALTER "
          "TABLE content DROP COLUMN sum; "
          "PRAGMA user_version = 3");
  const auto store = open_sqlite(directory.path());
  ASSERT_TRUE(store) << store.error().message;
  ASSERT_TRUE((*store)->open());
  EXPECT_EQ((*store)->content(hash).value(), delivery.contents[0]);
  EXPECT_EQ((*store)->stored_content(hash)->size, delivery.contents[0].size());
}

TEST(SqliteOpen, AStoreOfTheFourthSchemaIsMigratedAndItsPlacesCanBeKnownBetter) {
  const TemporaryDirectory directory;
  const auto delivery = sample::Run(0x11, 1).next(2);
  {
    const auto store = open_sqlite(directory.path());
    ASSERT_TRUE((*store)->open());
    ASSERT_TRUE((*store)->commit(sample::transaction(delivery)));
  }
  run_sql(directory.path() / "map.sqlite",
          "DROP TABLE registration; DROP TABLE rule; DROP TABLE hold; DROP TABLE awaited_label; DROP TABLE passes; "
          "DROP TABLE apart; DROP "
          "TABLE place_anew; PRAGMA "
          "user_version = 4");
  const auto store = open_sqlite(directory.path());
  ASSERT_TRUE(store) << store.error().message;
  ASSERT_TRUE((*store)->open());
  const Bytes better(100, 0x41);
  const Place anew = sample::known_anew(delivery.batch.places[1], better, sample::robot(2));
  ASSERT_TRUE(
      (*store)->commit({{PutContent{anew.content.hash, msg::ContentKind::content, better}, PutPlaces{{anew}}}}));
  EXPECT_EQ(*(*store)->snapshot_at({2}, {})->place(anew.id), anew);
}

TEST(SqliteOpen, SecondProcessOnTheSameStoreIsToldWhoHasIt) {
  const TemporaryDirectory directory;
  const auto store = open_sqlite(directory.path());
  ASSERT_TRUE(store) << store.error().message;
  const pid_t child = ::fork();
  if (child == 0) {
    const auto second = open_sqlite(directory.path());
    const bool is_told = !second && second.error().code == ErrorCode::unavailable &&
                         second.error().message.find("process " + std::to_string(::getppid())) != std::string::npos;
    ::_exit(is_told ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

TEST(SqliteOpen, LockGoesWithItsStore) {
  const TemporaryDirectory directory;
  { ASSERT_TRUE(open_sqlite(directory.path())); }
  EXPECT_TRUE(open_sqlite(directory.path()));
}

}  // namespace
}  // namespace weft::storage
