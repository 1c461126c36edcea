#include "clients/evaluate/floor/attempts/tally.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::evaluate::floor {
namespace {

const Pose2 kTruth{1.0, 0.2, 0.5};
const Pose2 kSeenFrom{4.0, 3.0, -1.0};

TEST(AttemptTally, OffByMoreThanATenthOrThreeDegreesIsWrong) {
  EXPECT_TRUE(is_right(kTruth * Pose2{0.09, 0.0, 0.05}, kTruth));
  EXPECT_FALSE(is_right(kTruth * Pose2{0.08, 0.08, 0.0}, kTruth));
  EXPECT_FALSE(is_right(kTruth * Pose2{0.0, 0.0, -0.06}, kTruth));
}

TEST(AttemptTally, CountsRightRefusedAndWrong) {
  Tally tally;
  tally.count("a", kTruth, kTruth, kSeenFrom);
  tally.count("a", tl::unexpected(agents::Refusal{"few_matches", 3.0, 24.0}), kTruth, kSeenFrom);
  tally.count("a", tl::unexpected(agents::Refusal{"few_matches", 4.0, 24.0}), std::nullopt, kSeenFrom);
  tally.count("b", kTruth * Pose2{0.3, 0.0, 0.0}, kTruth, kSeenFrom);
  EXPECT_EQ(tally.attempts(), 4U);
  EXPECT_EQ(tally.wrong(), 1U);
  EXPECT_EQ(tally.sorts["a"].right, 1U);
  EXPECT_EQ(tally.sorts["a"].refused["few_matches"], 2U);
  ASSERT_EQ(tally.wrong_ones.size(), 1U);
  EXPECT_NEAR(tally.wrong_ones[0].off_m, 0.3, 1e-9);
  EXPECT_EQ(tally.wrong_ones[0].site_from_robot, kSeenFrom * kTruth);
}

TEST(AttemptTally, OnAnotherFloorEveryPlaceIsWrong) {
  Tally tally;
  tally.count("a", kTruth, std::nullopt, kSeenFrom);
  EXPECT_EQ(tally.wrong(), 1U);
  EXPECT_TRUE(std::isnan(tally.wrong_ones[0].off_m));
}

TEST(AttemptTally, RecallFallsIntoBinsAndTheLastTakesTheRest) {
  Tally tally;
  tally.recall("a", {0.05, 0.0}, true);
  tally.recall("a", {0.06, 3.14}, false);
  tally.recall("a", {9.0, 0.3}, true);
  const Recall& recall = tally.recalls["a"];
  EXPECT_EQ(recall.tried_by_metres[0], 2U);
  EXPECT_EQ(recall.right_by_metres[0], 1U);
  EXPECT_EQ(recall.right_by_metres[Recall::kBins - 1], 1U);
  EXPECT_EQ(recall.tried_by_heading[Recall::kBins - 1], 1U);
  EXPECT_EQ(recall.right_by_heading[1], 1U);
}

TEST(AttemptTally, TwoAreAdded) {
  Tally one;
  one.count("a", kTruth, kTruth, kSeenFrom);
  one.recall("a", {0.05, 0.0}, true);
  Tally sum = one;
  one.count("b", kTruth, std::nullopt, kSeenFrom);
  sum.add(one);
  EXPECT_EQ(sum.attempts(), 3U);
  EXPECT_EQ(sum.wrong(), 1U);
  EXPECT_EQ(sum.wrong_ones.size(), 1U);
  EXPECT_EQ(sum.recalls["a"].right_by_metres[0], 2U);
}

}  // namespace
}  // namespace weft::evaluate::floor
