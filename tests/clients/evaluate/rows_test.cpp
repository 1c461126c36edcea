#include "clients/evaluate/disturbances/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "clients/evaluate/disturbances/summary.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate {
namespace {

using storage::TemporaryDirectory;

const Study kStudy{"1.0", "aa", "bb", 12.0};

Rows sample_rows() {
  Rows rows;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    rows[{"all", seed}].drift_mm = 10.0 * static_cast<double>(seed);
    rows[{"none", seed}].fix_mm = std::numeric_limits<double>::quiet_NaN();
  }
  return rows;
}

TEST(EvaluateRows, AreReadAsTheyWereWritten) {
  const TemporaryDirectory folder;
  ASSERT_TRUE(write_rows(folder.path(), kStudy, sample_rows()).has_value());
  const Result<Rows> rows = read_rows(folder.path(), kStudy);
  ASSERT_TRUE(rows.has_value()) << rows.error().message;
  EXPECT_EQ(rows->size(), 6U);
  EXPECT_EQ(rows->at({"all", 2}), sample_rows().at({"all", 2}));
  EXPECT_TRUE(std::isnan(rows->at({"none", 3}).fix_mm));
}

TEST(EvaluateRows, NoFileIsNoRows) {
  const TemporaryDirectory folder;
  EXPECT_TRUE(read_rows(folder.path(), kStudy).value().empty());
}

TEST(EvaluateRows, AnotherStudyIsLeftAloneAndSaysWhatDiffers) {
  const TemporaryDirectory folder;
  ASSERT_TRUE(write_rows(folder.path(), kStudy, sample_rows()).has_value());
  Study other = kStudy;
  other.metres = 20.0;
  const Result<Rows> rows = read_rows(folder.path(), other);
  ASSERT_FALSE(rows.has_value());
  EXPECT_EQ(rows.error().code, ErrorCode::conflict);
  EXPECT_NE(rows.error().message.find("other metres"), std::string::npos) << rows.error().message;
}

TEST(EvaluateRows, ADamagedFileIsNamed) {
  for (const char* const text : {"", "{", "{\"study\": 3}", "[]"}) {
    const TemporaryDirectory folder;
    std::ofstream(folder.path() / "disturbances.json") << text;
    const Result<Rows> rows = read_rows(folder.path(), kStudy);
    ASSERT_FALSE(rows.has_value()) << text;
    EXPECT_NE(rows.error().message.find("disturbances.json"), std::string::npos);
  }
}

TEST(EvaluateRows, CsvHasARowEachWithEmptyCellsForNothing) {
  const TemporaryDirectory folder;
  ASSERT_TRUE(write_csv(folder.path(), {"none", "all"}, sample_rows()).has_value());
  std::ifstream in(folder.path() / "disturbances.csv");
  std::string head;
  std::string first;
  std::getline(in, head);
  std::getline(in, first);
  EXPECT_EQ(head.rfind("variant,seed,speed_error_mm_s,", 0), 0U) << head;
  EXPECT_EQ(first, "\"none\",1,0,0,0,,0,0,0,0,0");
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(in), {}, '\n'), 5);
}

TEST(EvaluateSummary, MeansOfTheSeedsAskedFor) {
  const Spread spread = spread_of(sample_rows(), "all", {2, 3}, &Score::drift_mm);
  EXPECT_EQ(spread.mean, 25.0);
  EXPECT_EQ(spread.least, 20.0);
  EXPECT_EQ(spread.most, 30.0);
  EXPECT_TRUE(std::isnan(spread_of(sample_rows(), "none", {1, 3}, &Score::fix_mm).mean));
  const std::string table = table_of(sample_rows(), {"none", "all"}, {1, 3});
  EXPECT_NE(table.find("| all "), std::string::npos) << table;
  EXPECT_NE(table.find(" 20 |"), std::string::npos) << table;
  EXPECT_NE(table.find(" - |"), std::string::npos) << table;
}

}  // namespace
}  // namespace weft::evaluate
