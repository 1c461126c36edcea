#include "clients/evaluate/stereo/score.hpp"

#include <gtest/gtest.h>

namespace weft::evaluate::stereo {
namespace {

/// Returns a way of 19 steps of 0.1 m, in a bow.
std::vector<Pose3> bow(double step_m) {
  std::vector<Pose3> poses{Pose3{}};
  Vector6d step;
  step << step_m, 0.0, 0.002, 0.0, 0.0, 0.05;
  for (int i = 0; i < 19; ++i) poses.push_back(poses.back() * se3_exp(step));
  return poses;
}

struct Case {
  Followed followed;
  formats::Trajectory truth;
};
Case case_of(const std::vector<Pose3>& truth, const std::vector<Pose3>& ours, const std::vector<Pose3>& baseline) {
  Case one;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    one.followed.time_s.push_back(100.0 + 0.1 * static_cast<double>(i));
    one.truth.samples.push_back({one.followed.time_s.back(), truth[i]});
  }
  one.followed.ours = {ours, 19, 0.2};
  one.followed.baseline = {baseline, 18, 0.4};
  return one;
}

std::vector<Pose3> from_elsewhere(std::vector<Pose3> poses) {
  Vector6d away;
  away << 3.0, -2.0, 1.0, 0.3, 0.2, -1.0;
  for (Pose3& pose : poses) pose = se3_exp(away) * pose;
  return poses;
}

TEST(PathScore, APathFromElsewhereIsLaidOverTheTruth) {
  const Case one = case_of(from_elsewhere(bow(0.1)), bow(0.1), bow(0.11));
  const auto scored = score(one.followed, 1, one.truth);
  ASSERT_TRUE(scored);
  EXPECT_LT(scored->row.ours.ate_m, 1e-9);
  EXPECT_LT(scored->row.ours.end_m, 1e-9);
  EXPECT_LT(scored->row.ours.step_deg, 1e-6);
  EXPECT_GT(scored->row.baseline.ate_m, 0.01) << "its scale is not fitted";
  EXPECT_NEAR(scored->row.baseline.step_mm, 10.0, 0.01);
  EXPECT_NEAR(scored->row.hz, 10.0, 1e-6);
  EXPECT_NEAR(scored->row.way_m, 1.9, 0.01);
  EXPECT_NEAR(scored->row.ours.ms, 10.0, 1e-9);
  EXPECT_EQ(scored->row.baseline.seen, 18U);
  EXPECT_LT((scored->laid.ours.back() - scored->laid.truth.back()).norm(), 1e-9);
}

TEST(PathScore, AtRestAllThatMovesIsAnError) {
  const std::vector<Pose3> still(20, Pose3{});
  const Case one = case_of(from_elsewhere(still), still, bow(0.001));
  const auto scored = score(one.followed, 1, one.truth);
  ASSERT_TRUE(scored);
  EXPECT_TRUE(scored->row.is_at_rest());
  EXPECT_LT(scored->row.ours.ate_m, 1e-9);
  EXPECT_GT(scored->row.baseline.ate_m, 0.005);
}

TEST(PathScore, WithoutATruthThereIsNone) {
  Case one = case_of(bow(0.1), bow(0.1), bow(0.1));
  for (auto& sample : one.truth.samples) sample.time_s += 50.0;
  EXPECT_FALSE(score(one.followed, 1, one.truth));
}

}  // namespace
}  // namespace weft::evaluate::stereo
