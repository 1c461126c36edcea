#include "clients/evaluate/floor/other_promises.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

Tally attempts(std::size_t near, std::size_t elsewhere) {
  Tally tally;
  tally.sorts[attempted::kNear].right = near;
  tally.sorts[attempted::kElsewhere].refused["few_matches"] = elsewhere;
  return tally;
}

std::vector<Trial> found(std::size_t count, std::size_t lost = 0) {
  std::vector<Trial> trials(count);
  for (std::size_t i = lost; i < count; ++i) trials[i].found_m = 0.5;
  return trials;
}

TEST(OtherPromises, NoAttemptOfEnoughMayBeWrong) {
  EXPECT_TRUE(judge_attempts({}).groups.empty());
  AttemptRows rows;
  rows[{"wood", "same", 1}] = attempts(50'000, 49'999);
  EXPECT_FALSE(judge_attempts(rows).met) << "one is lacking";
  rows[{"wood", "halved", 1}] = attempts(0, 1);
  EXPECT_TRUE(judge_attempts(rows).met);
  EXPECT_EQ(judge_attempts(rows).of, 100'000U);
  rows[{"wood", "halved", 2}] = attempts(1, 0);
  EXPECT_FALSE(judge_attempts(rows).met) << "less than half have no right answer";
  rows[{"wood", "halved", 2}] = attempts(0, 10);
  rows[{"wood", "halved", 2}].sorts[attempted::kElsewhere].wrong = 1;
  const Judged wrong = judge_attempts(rows);
  EXPECT_FALSE(wrong.met);
  EXPECT_EQ(wrong.worst, 1.0);
}

TEST(OtherPromises, RobotsFindThemselvesOnEveryFloorThatDoesNotRepeat) {
  EXPECT_TRUE(judge_trials({}).groups.empty());
  TrialRows rows;
  rows[{"wood", "same", 1}] = found(900);
  EXPECT_FALSE(judge_trials(rows).met) << "too few";
  rows[{"asphalt", "same", 1}] = found(100, 1);
  EXPECT_TRUE(judge_trials(rows).met);
  EXPECT_EQ(judge_trials(rows).median, 99.0);
  rows[{"tiles", "same", 1}] = found(100, 100);
  EXPECT_TRUE(judge_trials(rows).met) << "there a refusal is right";
  EXPECT_EQ(judge_trials(rows).of, 1'000U);
  rows[{"asphalt", "same", 1}] = found(100, 4);
  EXPECT_FALSE(judge_trials(rows).met);
}

class OthersInAFolder : public testing::Test {
 protected:
  storage::TemporaryDirectory folder;
  Study study{"1", "site", "line", "", 26.0};
};

TEST_F(OthersInAFolder, AreReadWhateverLineTheyDrove) {
  Study longer = study;
  longer.line_sha256.clear();
  longer.metres = 1000.0;
  TrialRows trials;
  trials[{"wood", "same", 1}] = found(1000);
  ASSERT_TRUE(write_trials(folder.path(), longer, trials).has_value());
  AttemptRows rows;
  rows[{"wood", "same", 1}] = attempts(1, 1);
  ASSERT_TRUE(write_attempts(folder.path(), {study, 2}, rows).has_value());
  const auto judged = judge_others(folder.path(), study);
  ASSERT_TRUE(judged.has_value()) << judged.error().message;
  EXPECT_EQ(judged->at(0).of, 2U);
  EXPECT_EQ(judged->at(1).of, 1000U);
}

TEST_F(OthersInAFolder, OfAnotherSiteOrNotThereWereNotMeasured) {
  const auto nothing = judge_others(folder.path(), study);
  ASSERT_TRUE(nothing.has_value()) << nothing.error().message;
  EXPECT_TRUE(nothing->at(0).groups.empty());
  EXPECT_STREQ(nothing->at(0).command, "floor-attempts");
  Study other = study;
  other.site_sha256 = "another";
  TrialRows trials;
  trials[{"wood", "same", 1}] = found(1000);
  ASSERT_TRUE(write_trials(folder.path(), other, trials).has_value());
  EXPECT_TRUE(judge_others(folder.path(), study)->at(1).groups.empty());
}

TEST_F(OthersInAFolder, ThatAreDamagedAreNamed) {
  std::ofstream(folder.path() / "attempts.json") << "{";
  const auto refused = judge_others(folder.path(), study);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::corrupt);
  EXPECT_NE(refused.error().message.find("attempts.json"), std::string::npos) << refused.error().message;
}

}  // namespace
}  // namespace weft::evaluate::floor
