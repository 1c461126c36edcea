#include "clients/evaluate/topometric/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "clients/evaluate/files.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::topometric {
namespace {

const Study kMeasuredOf{"1.0", "aa", {}};

Rows some_rows() {
  Rows rows;
  rows[{trial::kDeliveries, 2}].values = {{"open_m", 0.5}, {"goal_median_m", Score::kNothing}};
  rows[{trial::kMap, 1}].values = {{"places", 104.0}};
  return rows;
}

TEST(TopometricRows, AreReadAsTheyWereWritten) {
  const storage::TemporaryDirectory folder;
  ASSERT_TRUE(write_rows(folder.path(), kMeasuredOf, some_rows(), judge(some_rows(), {1, 5}, false)));
  const Result<Rows> rows = read_rows(folder.path(), kMeasuredOf);
  ASSERT_TRUE(rows) << rows.error().message;
  EXPECT_EQ(rows->size(), 2U);
  EXPECT_EQ(rows->at({trial::kDeliveries, 2}).value("open_m"), 0.5);
  EXPECT_TRUE(rows->at({trial::kDeliveries, 2}).values.contains("goal_median_m"));
  EXPECT_TRUE(std::isnan(rows->at({trial::kDeliveries, 2}).value("goal_median_m")));
}

TEST(TopometricRows, AnotherStudyIsLeftAlone) {
  const storage::TemporaryDirectory folder;
  ASSERT_TRUE(write_rows(folder.path(), kMeasuredOf, some_rows(), {}));
  Study other = kMeasuredOf;
  other.extent.width_px = 480;
  const Result<Rows> rows = read_rows(folder.path(), other);
  ASSERT_FALSE(rows);
  EXPECT_EQ(rows.error().code, ErrorCode::conflict);
  EXPECT_NE(rows.error().message.find("width_px"), std::string::npos) << rows.error().message;
}

TEST(TopometricRows, TheDocumentHasEachBoundWithItsVerdict) {
  const nlohmann::json document = document_of(kMeasuredOf, some_rows(), judge(some_rows(), {1, 5}, false));
  EXPECT_EQ(document.at("bounds").size(), bounds().size());
  EXPECT_EQ(document.at("bounds").at(0).at("row"), "O1");
  EXPECT_EQ(document.at("bounds").at(0).at("verdict"), "met");
}

TEST(TopometricRows, TheTableOfNumbersHasARowEach) {
  const storage::TemporaryDirectory folder;
  ASSERT_TRUE(write_csv(folder.path(), some_rows()));
  const Result<std::string> text = read_text(folder.path() / "topometric.csv", "");
  ASSERT_TRUE(text);
  EXPECT_NE(text->find("\"deliveries\",2,\"open_m\",0.5"), std::string::npos) << *text;
}

}  // namespace
}  // namespace weft::evaluate::topometric
