#include "clients/evaluate/ceiling/bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace weft::evaluate::ceiling {
namespace {

Judged judged_of(const Rows& rows, const std::string& measure, Seeds seeds = {1, 3}) {
  const std::vector<Judged> all = judge(rows, seeds);
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Judged& one) { return one.bound->measure == measure; });
  return found == all.end() ? Judged{} : *found;
}

TEST(CeilingBounds, OfNothingNothingIsMeasuredAndNothingMissed) {
  const std::vector<Judged> all = judge({}, {1, 5});
  ASSERT_FALSE(all.empty());
  for (const Judged& judged : all) EXPECT_EQ(judged.verdict, Verdict::not_measured) << judged.bound->measure;
  EXPECT_FALSE(is_any_missed(all));
}

TEST(CeilingBounds, TheLineIsDrivenWithTwiceAsManySeeds) {
  EXPECT_EQ(seeds_of(trial::kLine, {1, 5}).last, 10U);
  EXPECT_EQ(seeds_of(trial::kLine, {1, 1}).last, 1U);
  EXPECT_EQ(seeds_of(trial::kLoop, {1, 5}).last, 5U);
  Rows rows;
  for (std::uint64_t seed = 1; seed <= 7; ++seed) rows[{trial::kLine, seed}].values["lateral_rms_mm"] = 5.0;
  EXPECT_EQ(judged_of(rows, "line: lateral RMS").seeds, 6U);
}

TEST(CeilingBounds, MedianAndWorstAreHeldApart) {
  Rows rows;
  const double values[] = {4.0, 9.0, 14.0};
  for (std::uint64_t i = 0; i < 3; ++i) {
    rows[{trial::kLine, i + 1}].values["lateral_rms_mm"] = values[i];
    rows[{trial::kLine, i + 1}].values["published_rms_mm"] = 100.0 + values[i];
  }
  const Judged good = judged_of(rows, "line: lateral RMS");
  EXPECT_EQ(good.verdict, Verdict::met);
  EXPECT_EQ(good.median, 9.0);
  EXPECT_EQ(good.worst, 14.0);
  EXPECT_EQ(good.baseline, 109.0);
  rows[{trial::kLine, 3}].values["lateral_rms_mm"] = 16.0;
  EXPECT_EQ(judged_of(rows, "line: lateral RMS").verdict, Verdict::missed);
}

TEST(CeilingBounds, WhoDoesNotArriveHasMissed) {
  Rows rows;
  rows[{trial::kLine, 1}].values["lateral_rms_mm"] = Score::kNothing;
  EXPECT_EQ(judged_of(rows, "line: lateral RMS").verdict, Verdict::missed);
}

TEST(CeilingBounds, AtLeastIsMirrored) {
  Rows rows;
  rows[{trial::kFound, 1}].values["found_percent"] = 99.5;
  rows[{trial::kFound, 2}].values["found_percent"] = 90.0;
  rows[{trial::kFound, 3}].values["found_percent"] = 100.0;
  const Judged judged = judged_of(rows, "put down: found in 1 s, same light");
  EXPECT_EQ(judged.verdict, Verdict::met);
  EXPECT_EQ(judged.worst, 90.0);
}

TEST(CeilingBounds, WrongRelationsAreSummedOverAllTrialsAndOfFewNotJudged) {
  Rows rows;
  rows[{trial::kLine, 1}].values = {{"fixes", 100.0}, {"wrong_fixes", 0.0}};
  rows[{trial::kFound, 1}].values = {{"accepted", 400.0}, {"wrong_accepted", 0.0}};
  const std::string measure = "accepted relations that are wrong";
  EXPECT_EQ(judged_of(rows, measure).verdict, Verdict::too_few);
  EXPECT_EQ(judged_of(rows, measure).worst, 500.0);
  rows[{trial::kFound, 1}].values["accepted"] = 5000.0;
  EXPECT_EQ(judged_of(rows, measure).verdict, Verdict::met);
  rows[{trial::kLoop, 1}].values = {{"stitches", 3.0}, {"wrong_stitches", 1.0}};
  EXPECT_EQ(judged_of(rows, measure).verdict, Verdict::missed);
}

TEST(CeilingBounds, ALoopThatIsNotRefinedSaysSo) {
  Rows rows;
  rows[{trial::kLoop, 1}].values = {{"refined", 0.0}, {"drift_percent", 0.5}};
  EXPECT_EQ(judged_of(rows, "loop: places after adjustment").verdict, Verdict::not_refined);
  EXPECT_EQ(judged_of(rows, "loop: open drift").verdict, Verdict::met);
  EXPECT_TRUE(is_any_missed(judge(rows, {1, 3})));
  EXPECT_NE(table_of(judge(rows, {1, 3})).find("not refined"), std::string::npos);
}

TEST(CeilingBounds, ShortDrivesSayNothingOfLongStretches) {
  Rows rows;
  rows[{trial::kLine, 1}].values["held_10m_percent"] = Score::kNothing;
  EXPECT_EQ(judged_of(rows, "95 % region of 10 m holds").verdict, Verdict::not_measured);
  rows[{trial::kLoop, 1}].values["held_10m_percent"] = 95.0;
  EXPECT_EQ(judged_of(rows, "95 % region of 10 m holds").verdict, Verdict::met);
}

TEST(CeilingBounds, OnlyTheRowsThatAreAskedFor) {
  for (const Judged& judged : judge({}, {1, 1}, {1, 6}))
    EXPECT_TRUE(judged.bound->row == 1 || judged.bound->row == 6);
}

}  // namespace
}  // namespace weft::evaluate::ceiling
