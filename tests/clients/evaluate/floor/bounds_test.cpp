#include "clients/evaluate/floor/bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "clients/evaluate/floor/scenario.hpp"

namespace weft::evaluate::floor {
namespace {

const Judged& of(const std::vector<Judged>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Judged& judged) { return judged.bound->name == name; });
  EXPECT_NE(found, all.end()) << name;
  return *found;
}

Score repeat_with(double goal_mm, double blind_m) {
  Score score;
  score.metres = 20.0;
  score.goal_mm = goal_mm;
  score.blind_m = blind_m;
  score.wrong_fixes = 0.0;
  return score;
}

TEST(FloorBounds, MedianAndWorst) {
  EXPECT_EQ(median_worst({3.0, 1.0, 2.0}).median, 2.0);
  EXPECT_EQ(median_worst({3.0, 1.0, 2.0, 10.0}).median, 2.5);
  EXPECT_EQ(median_worst({3.0, 1.0, 2.0}).worst, 3.0);
  EXPECT_TRUE(std::isinf(median_worst({1.0, Score::kNothing, 1.0}).worst));
  EXPECT_TRUE(std::isnan(median_worst({}).median));
}

TEST(FloorBounds, TheWorstGroupDecides) {
  Rows rows;
  rows[{"concrete", "same", 1}] = repeat_with(5.0, 0.1);
  rows[{"concrete", "same", 2}] = repeat_with(39.0, 0.1);
  rows[{"concrete", "same", 3}] = repeat_with(6.0, 0.1);
  rows[{"asphalt", "same", 1}] = repeat_with(8.0, 0.1);
  const auto good = judge(rows, {1, 3});
  EXPECT_TRUE(of(good, "goal, position").met);
  EXPECT_EQ(of(good, "goal, position").median, 8.0);
  EXPECT_EQ(of(good, "goal, position").worst, 39.0);
  rows[{"asphalt", "same", 1}].goal_mm = 25.0;
  const auto bad = judge(rows, {1, 3});
  EXPECT_FALSE(of(bad, "goal, position").met);
  EXPECT_EQ(of(bad, "goal, position").groups.size(), 2U);
  EXPECT_TRUE(of(judge(rows, {2, 3}), "goal, position").groups.size() == 1U);
}

TEST(FloorBounds, OneThatWasMeasuredAndDoesNotHoldIsMissed) {
  Rows rows;
  EXPECT_FALSE(is_any_missed(judge(rows, {1, 1}))) << "nothing was measured";
  Score& score = rows[{"concrete", kMapping, 1}];
  score.speed_percent = score.speed_wrong_mount_percent = score.speed_fast_percent = 0.3;
  score.held_1m_percent = score.held_10m_percent = 95.0;
  EXPECT_FALSE(is_any_missed(judge(rows, {1, 1})));
  score.speed_percent = 1.2;
  EXPECT_TRUE(is_any_missed(judge(rows, {1, 1})));
}

TEST(FloorBounds, WhatWasNotMeasuredIsNotMet) {
  Rows rows;
  rows[{"concrete", "same", 1}] = repeat_with(5.0, 0.1);
  const auto judged = judge(rows, {1, 1});
  EXPECT_FALSE(of(judged, "goal, heading").met);
  EXPECT_FALSE(of(judged, "speed error while mapping").met);
  EXPECT_TRUE(of(judged, "speed error while mapping").groups.empty());
}

TEST(FloorBounds, TexturedFloorsInTheirOwnLightHaveNarrowerBounds) {
  Rows rows;
  rows[{"concrete", "same", 1}] = repeat_with(5.0, 0.3);
  rows[{"epoxy", "same", 1}] = repeat_with(5.0, 0.45);
  rows[{"concrete", "halved", 1}] = repeat_with(5.0, 0.45);
  const auto judged = judge(rows, {1, 1});
  EXPECT_FALSE(of(judged, "blind distance, textured").met);
  EXPECT_EQ(of(judged, "blind distance, textured").groups.size(), 1U);
  EXPECT_TRUE(of(judged, "blind distance, hardest floor and light").met);
  EXPECT_EQ(of(judged, "blind distance, hardest floor and light").groups.size(), 2U);
}

TEST(FloorBounds, AFloorThatRepeatsItselfMayBeRefusedButNotMistaken) {
  Rows rows;
  rows[{"tiles", "same", 1}] = repeat_with(9000.0, 20.0);
  rows[{"tiles", "same", 1}].wrong_fixes = 1.0;
  const auto judged = judge(rows, {1, 1});
  EXPECT_TRUE(of(judged, "goal, position").groups.empty());
  EXPECT_FALSE(of(judged, "wrong fixes in the repeats").met);
}

TEST(FloorBounds, HowOftenRegionsHoldIsAMeanOverFloorsThatSetNothing) {
  Rows rows;
  rows[{"epoxy", kMapping, 1}].held_1m_percent = 20.0;
  rows[{"wood", kMapping, 1}].held_1m_percent = 88.0;
  rows[{"wood", kMapping, 2}].held_1m_percent = 96.0;
  rows[{"asphalt", kMapping, 1}].held_1m_percent = 98.0;
  const std::string name = "95 % region of 1 m holds the truth, mount calibrated, floors that set nothing";
  const auto judged = judge(rows, {1, 2});
  EXPECT_EQ(of(judged, name).median, 94.0);
  EXPECT_TRUE(of(judged, name).met);
  EXPECT_EQ(of(judged, name).groups.size(), 2U);
  rows[{"asphalt", kMapping, 2}].held_1m_percent = 50.0;
  EXPECT_FALSE(of(judge(rows, {1, 2}), name).met);
}

TEST(FloorBounds, HowOftenRegionsHoldIsJudgedOfFortySeeds) {
  Rows rows;
  const std::string name = "95 % region of 1 m holds the truth, mount calibrated, floors that set nothing";
  const auto drive = [&rows](std::uint64_t seed) {
    Score& score = rows[{"wood", kMapping, seed}];
    score.speed_percent = score.speed_wrong_mount_percent = score.speed_fast_percent = 0.3;
    score.held_1m_percent = score.held_10m_percent = 60.0;
  };
  for (std::uint64_t seed = 1; seed <= 39; ++seed) drive(seed);
  EXPECT_FALSE(of(judge(rows, {1, 40}), name).is_judged);
  EXPECT_FALSE(is_any_missed(judge(rows, {1, 40})));
  drive(40);
  EXPECT_TRUE(of(judge(rows, {1, 40}), name).is_judged);
  EXPECT_TRUE(is_any_missed(judge(rows, {1, 40})));
}

}  // namespace
}  // namespace weft::evaluate::floor
