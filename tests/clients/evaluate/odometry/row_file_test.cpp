#include "clients/evaluate/odometry/row_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::odometry {
namespace {

class OdometryRowFile : public testing::Test {
 protected:
  static std::vector<Row> rows() {
    Row row{"wood", 2001, kMappingDrive, kCalibrated, 0.2, 0.9, floor::Score::kNothing, 0.1, 8.5, {0.25, 9.0}, {}};
    return {row, row};
  }
  storage::TemporaryDirectory folder;
  floor::Study study{"weft 1", "site", "line", "", 26.0};
};

TEST_F(OdometryRowFile, GivesBackWhatWasWritten) {
  EXPECT_TRUE(read_odometry_rows(folder.path(), study)->empty()) << "nothing is there yet";
  ASSERT_TRUE(write_odometry_rows(folder.path(), study, rows()));
  const auto read = read_odometry_rows(folder.path(), study);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->size(), 2U);
  EXPECT_EQ(read->front().seed, 2001U);
  EXPECT_EQ(read->front().over_1m, (std::vector<double>{0.25, 9.0}));
  EXPECT_TRUE(std::isnan(read->front().drift_deg));
}

TEST_F(OdometryRowFile, OfAnotherStudyIsRefusedByName) {
  ASSERT_TRUE(write_odometry_rows(folder.path(), study, rows()));
  study.metres = 8.0;
  const auto read = read_odometry_rows(folder.path(), study);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::conflict);
  EXPECT_NE(read.error().message.find("metres"), std::string::npos) << read.error().message;
}

TEST_F(OdometryRowFile, ThatIsCutShortIsCorrupt) {
  ASSERT_TRUE(write_odometry_rows(folder.path(), study, rows()));
  std::ofstream(folder.path() / "odometry.json") << R"({"study": {)";
  const auto read = read_odometry_rows(folder.path(), study);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::corrupt);
  EXPECT_NE(read.error().message.find("odometry.json"), std::string::npos);
}

}  // namespace
}  // namespace weft::evaluate::odometry
