#include <gtest/gtest.h>

#include "storage/sqlite/row_reading.hpp"
#include "storage/sqlite/schema.hpp"
#include "tests/storage/temporary_directory.hpp"

/// Tests what SQLite makes of the schema.
namespace weft::storage::sqlite {
namespace {

struct KeyColumn {
  std::string name;  ///< "table.column"
  std::uint64_t stands_at = 0;
  std::uint64_t of_key = 0;
};

/// Returns the columns of the keys of all tables WITHOUT ROWID, as positions from 0 in the table and in the key.
std::vector<KeyColumn> key_columns(const Database& database) {
  std::vector<KeyColumn> columns;
  const auto done = for_each_row(database,
                                 "SELECT tables.name || '.' || columns.name, columns.cid, columns.pk - 1"
                                 " FROM pragma_table_list AS tables JOIN pragma_table_info(tables.name) AS columns"
                                 " WHERE tables.wr = 1 AND columns.pk > 0",
                                 [&](const Query& row) {
                                   columns.push_back({row.text(0), row.number(1), row.number(2)});
                                 });
  EXPECT_TRUE(done) << done.error().message;
  return columns;
}

TEST(SqliteSchema, KeyColumnsComeFirstAndInTheOrderOfTheKey) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "map.sqlite";
  const auto database = Database::open(file, "");
  ASSERT_TRUE(database);
  ASSERT_TRUE(prepare_schema(*database, file));
  const std::vector<KeyColumn> columns = key_columns(*database);
  EXPECT_GE(columns.size(), 25U) << "the schema's tables are not seen";
  for (const KeyColumn& column : columns) {
    EXPECT_EQ(column.stands_at, column.of_key)
        << column.name << ": quick_check would find NULL in the columns that stand before it";
  }
}

}  // namespace
}  // namespace weft::storage::sqlite
