#include "clients/evaluate/ceiling/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "clients/evaluate/files.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::ceiling {
namespace {

const Study kMeasured{"1.0", "aa", "recording", {}};

Rows measured_rows() {
  Rows rows;
  rows[{trial::kLine, 2}].values = {{"lateral_rms_mm", 7.5}, {"goal_mm", Score::kNothing}};
  rows[{trial::kFrames, 0}].values = {{"lost", 0.0}};
  return rows;
}

TEST(CeilingRows, AreReadAsTheyWereWritten) {
  const storage::TemporaryDirectory folder;
  ASSERT_TRUE(write_rows(folder.path(), kMeasured, measured_rows(), judge(measured_rows(), {1, 5})));
  const Result<Rows> rows = read_rows(folder.path(), kMeasured);
  ASSERT_TRUE(rows) << rows.error().message;
  EXPECT_EQ(rows->size(), 2U);
  EXPECT_EQ(rows->at({trial::kLine, 2}).value("lateral_rms_mm"), 7.5);
  EXPECT_TRUE(std::isnan(rows->at({trial::kLine, 2}).value("goal_mm")));
  EXPECT_TRUE(rows->at({trial::kLine, 2}).values.contains("goal_mm"));
}

TEST(CeilingRows, AnotherStudyIsLeftAlone) {
  const storage::TemporaryDirectory folder;
  ASSERT_TRUE(write_rows(folder.path(), kMeasured, measured_rows(), {}));
  Study other = kMeasured;
  other.extent.put_downs = 40;
  const Result<Rows> rows = read_rows(folder.path(), other);
  ASSERT_FALSE(rows);
  EXPECT_EQ(rows.error().code, ErrorCode::conflict);
  EXPECT_NE(rows.error().message.find("put_downs"), std::string::npos) << rows.error().message;
}

TEST(CeilingRows, TheTableOfNumbersHasARowEach) {
  const storage::TemporaryDirectory folder;
  ASSERT_TRUE(write_csv(folder.path(), measured_rows()));
  const Result<std::string> text = read_text(folder.path() / "ceiling.csv", "");
  ASSERT_TRUE(text);
  EXPECT_NE(text->find("\"line\",2,\"lateral_rms_mm\",7.5"), std::string::npos) << *text;
}

}  // namespace
}  // namespace weft::evaluate::ceiling
