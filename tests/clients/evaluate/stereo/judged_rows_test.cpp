#include "clients/evaluate/stereo/rows.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "clients/evaluate/files.hpp"

namespace weft::evaluate::stereo {
namespace {

using testing::HasSubstr;

RateRow row_of(std::size_t every, double ours_m, double baseline_m) {
  RateRow row;
  row.every = every;
  row.hz = 20.0 / static_cast<double>(every);
  row.pairs = 112;
  row.way_m = 1.6;
  row.ours = {111, ours_m, 0.01, 0.9, 0.05, 4.0};
  row.baseline = {111, baseline_m, 0.02, 1.9, 0.06, 9.0};
  return row;
}

TEST(StereoRows, AreReadAsTheyWereWritten) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("stereo-rows" + std::to_string(::getpid()) + ".json");
  Rows rows{{row_of(1, 0.005, 0.006), row_of(2, 0.006, 0.007)}, DenseRow{14, 1, 0.6, 0.7, 0.95, 9.0, 30.0}};
  const nlohmann::json study = {{"study", "stereo"}};
  ASSERT_TRUE(write_rows(file, study, rows));
  const Result<Rows> read = read_rows(file, study);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(judge("a", *read).json, judge("a", rows).json);
  EXPECT_EQ(read->find(2)->baseline.ate_m, 0.007);
  EXPECT_EQ(read->find(3), nullptr);
  ASSERT_TRUE(write_text(file, R"({"study": {"study": "stereo"}, "rates": [{}]})"));
  EXPECT_EQ(read_rows(file, study).error().code, ErrorCode::corrupt);
  std::filesystem::remove(file);
}

TEST(StereoRows, NoWorseThanTheBaselineIsAskedOfAny) {
  EXPECT_TRUE(judge("any", {{row_of(1, 0.5, 0.5)}, {}}).is_met);
  const Judged worse = judge("any", {{row_of(1, 0.51, 0.5)}, {}});
  EXPECT_FALSE(worse.is_met);
  EXPECT_THAT(worse.table, HasSubstr("<= 0.5000 NOT MET (KLT + PnP)"));
  EXPECT_FALSE(judge("any", {}).is_met) << "nothing was measured";
}

TEST(StereoRows, RecordingsWithANameHaveBounds) {
  EXPECT_EQ(asked_of("euroc-mh01-600", row_of(1, 0, 0)).ate_m, 0.007);
  EXPECT_EQ(asked_of("euroc-mh01-600", row_of(2, 0, 0)).ate_m, 0.007);
  EXPECT_EQ(asked_of("euroc-mh01-600", row_of(4, 0, 0)).ate_m, 0.012);
  EXPECT_EQ(asked_of("euroc-mh01-600", row_of(3, 0, 0)).ate_m, 0.0);
  EXPECT_EQ(asked_of("KITTI_sequence_1", row_of(1, 0, 0)).ate_m, 0.12);
  EXPECT_EQ(asked_of("KITTI_sequence_1", row_of(1, 0, 0)).ms, 8.0);
  RateRow rest = row_of(1, 0.0005, 0.0006);
  rest.way_m = 0.001;
  EXPECT_EQ(asked_of("any", rest).ate_m, 0.001);
  EXPECT_FALSE(judge("KITTI_sequence_1", {{row_of(1, 0.13, 0.2)}, {}}).is_met);
  RateRow slow = row_of(1, 0.1, 0.2);
  EXPECT_TRUE(judge("KITTI_sequence_1", {{slow}, {}}).is_met);
  slow.ours.ms = 8.1;
  EXPECT_THAT(judge("KITTI_sequence_1", {{slow}, {}}).table, HasSubstr("<= 8 NOT MET"));
}

}  // namespace
}  // namespace weft::evaluate::stereo
