#include <gtest/gtest.h>

#include <cmath>

#include "clients/evaluate/topometric/bounds.hpp"
#include "clients/evaluate/topometric/trials.hpp"

namespace weft::evaluate::topometric {
namespace {

const Judged& of(const std::vector<Judged>& all, const std::string& trial, const std::string& value) {
  for (const Judged& one : all)
    if (trial == one.bound->trial && value == one.bound->value) return one;
  throw std::out_of_range(trial + ": " + value);
}

Rows with(const std::string& trial, const std::string& value, const std::vector<double>& values) {
  Rows rows;
  for (std::size_t i = 0; i < values.size(); ++i) rows[{trial, i + 1}].values[value] = values[i];
  return rows;
}

TEST(TopometricBounds, MedianAndWorstAreBothHeld) {
  const auto verdict = [](const std::vector<double>& values, bool by_worst = false) {
    return of(judge(with(trial::kDeliveries, "open_m", values), {1, 5}, by_worst), trial::kDeliveries, "open_m")
        .verdict;
  };
  EXPECT_EQ(verdict({0.9, 0.8, 2.4}), Verdict::met);
  EXPECT_EQ(verdict({1.1, 1.2, 0.3}), Verdict::missed) << "the median is 1.1 m";
  EXPECT_EQ(verdict({0.9, 0.8, 2.6}), Verdict::missed) << "the worst is beyond 2.5 m";
  EXPECT_EQ(verdict({1.1, 1.2, 0.3}, true), Verdict::met);
  EXPECT_EQ(verdict({0.5, Score::kNothing}), Verdict::missed) << "no number is the worst";
  EXPECT_EQ(verdict({}), Verdict::not_measured);
}

TEST(TopometricBounds, AtLeastIsMirrored) {
  const auto all = judge(with(trial::kDeliveries, "raw_times_open", {9.0, 6.0, 2.9}), {1, 3}, false);
  const Judged& judged = of(all, trial::kDeliveries, "raw_times_open");
  EXPECT_EQ(judged.verdict, Verdict::missed);
  EXPECT_EQ(judged.median, 6.0);
  EXPECT_EQ(judged.worst, 2.9);
  EXPECT_TRUE(is_any_missed(all));
}

TEST(TopometricBounds, AShareLiesBetweenAndTheWorstIsFarthestFromItsMiddle) {
  const auto judged = [](const std::vector<double>& values) {
    return of(judge(with(trial::kDeliveries, "blind_percent", values), {1, 3}, false), trial::kDeliveries,
              "blind_percent");
  };
  EXPECT_EQ(judged({4.0, 8.0, 14.0}).verdict, Verdict::met);
  EXPECT_EQ(judged({4.0, 8.0, 14.5}).worst, 14.5);
  EXPECT_EQ(judged({2.0, 8.0, 9.0}).verdict, Verdict::missed);
}

TEST(TopometricBounds, FourOfFiveObstacleDrivesMayReach) {
  const auto verdict = [](const std::vector<double>& values) {
    return of(judge(with(trial::kObstacles, "reached_percent", values), {1, 5}, false), trial::kObstacles,
              "reached_percent")
        .verdict;
  };
  EXPECT_EQ(verdict({100.0, 100.0, 0.0, 100.0, 100.0}), Verdict::met);
  EXPECT_EQ(verdict({100.0, 100.0, 0.0, 0.0, 100.0}), Verdict::missed);
}

TEST(TopometricBounds, OtherSeedsDoNotCount) {
  const Rows rows = with(trial::kDeliveries, "open_m", {9.0, 0.5, 0.5, 0.5});
  EXPECT_EQ(of(judge(rows, {2, 2}, false), trial::kDeliveries, "open_m").seeds, 1U);
  EXPECT_EQ(of(judge(rows, {1, 5}, false), trial::kDeliveries, "open_m").seeds, 3U) << "three at most";
}

TEST(TopometricBounds, EachTrialHasOneAndTheTableShowsWhatIsAsked) {
  for (const std::string& name : all_trials()) {
    const std::vector<Bound>& all = bounds();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Bound& bound) { return name == bound.trial; })) << name;
  }
  const std::string table = table_of(judge(with(trial::kDeliveries, "open_m", {0.25}), {1, 1}, false));
  EXPECT_NE(table.find("<= 1.00 (2.50)"), std::string::npos) << table;
  EXPECT_NE(table.find("not measured"), std::string::npos);
}

}  // namespace
}  // namespace weft::evaluate::topometric
