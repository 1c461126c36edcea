#include "clients/evaluate/floor/attempts/attempt_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "clients/evaluate/floor/attempts/attempt_report.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

class AttemptsFolder : public testing::Test {
 protected:
  AttemptsFolder() {
    Tally& tally = rows[{"tiles", "halved", 4}];
    tally.count(attempted::kNear, Pose2{0.1, 0.0, 0.0}, Pose2{0.1, 0.0, 0.0}, {});
    tally.count(attempted::kNear, tl::unexpected(agents::Refusal{"ambiguous", 2.0, 0.7}), Pose2{}, {});
    tally.count(attempted::kOtherFloor, Pose2{0.1, 0.0, 0.0}, std::nullopt, {1.0, 2.0, 0.5});
    tally.recall(attempted::kNear, {0.1, 0.2}, true);
  }
  storage::TemporaryDirectory folder;
  AttemptsStudy study{{"1", "site", "line", "", 26.0}, 1000};
  AttemptRows rows;
};

TEST_F(AttemptsFolder, RowsComeBackAsTheyWere) {
  EXPECT_TRUE(read_attempts(folder.path(), study)->empty());
  ASSERT_TRUE(write_attempts(folder.path(), study, rows).has_value());
  const auto back = read_attempts(folder.path(), study);
  ASSERT_TRUE(back.has_value()) << back.error().message;
  const Tally& tally = back->at({"tiles", "halved", 4});
  EXPECT_EQ(tally.attempts(), 3U);
  EXPECT_EQ(tally.wrong(), 1U);
  EXPECT_EQ(tally.sorts.at(attempted::kNear).refused.at("ambiguous"), 1U);
  EXPECT_EQ(tally.recalls.at(attempted::kNear).right_by_metres[1], 1U);
  ASSERT_EQ(tally.wrong_ones.size(), 1U);
  EXPECT_TRUE(std::isnan(tally.wrong_ones[0].off_m));
  EXPECT_EQ(tally.wrong_ones[0].site_from_place, (Pose2{1.0, 2.0, 0.5}));
}

TEST_F(AttemptsFolder, OfAnotherStudyIsRefused) {
  ASSERT_TRUE(write_attempts(folder.path(), study, rows).has_value());
  study.attempts_a_row = 2000;
  const auto refused = read_attempts(folder.path(), study);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::conflict);
  EXPECT_NE(refused.error().message.find("attempts_a_row"), std::string::npos) << refused.error().message;
  std::ofstream(folder.path() / "attempts.json") << "{";
  EXPECT_EQ(read_attempts(folder.path(), study).error().code, ErrorCode::corrupt);
}

TEST_F(AttemptsFolder, ATableALineAndAPictureOfEverything) {
  ASSERT_TRUE(write_attempts_csv(folder.path(), rows).has_value());
  std::ifstream in(folder.path() / "attempts.csv");
  const std::string csv{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(csv.find("\"tiles\",\"halved\",4,\"near\",\"ambiguous\",1\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\"other floor\",\"WRONG\",1\n"), std::string::npos) << csv;
  const std::string tables = tables_of(rows);
  EXPECT_NE(tables.find("| tiles | halved |        3 |    50.0 |"), std::string::npos) << tables;
  EXPECT_NE(tables.find("WRONG: floor"), std::string::npos) << tables;
}

}  // namespace
}  // namespace weft::evaluate::floor
