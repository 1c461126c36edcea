#include "clients/evaluate/ceiling/frames/compared.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::evaluate::ceiling {
namespace {

std::vector<Pose2> bending_way() {
  std::vector<Pose2> poses;
  for (int i = 0; i < 30; ++i) poses.push_back({0.1 * i, 0.02 * i * i * 0.1, 0.03 * i});
  return poses;
}

std::vector<Pose2> seen_from(const Pose2& b_from_a, const std::vector<Pose2>& in_a, double scale = 1.0) {
  std::vector<Pose2> in_b;
  for (const Pose2& pose : in_a) in_b.push_back(b_from_a * Pose2{scale * pose.x, scale * pose.y, pose.heading});
  return in_b;
}

TEST(ComparedPoses, AnotherFrameLeavesNothing) {
  const std::vector<Pose2> in_a = bending_way();
  const Pose2 b_from_a{3.0, -2.0, 2.5};
  const Alignment found = aligned(in_a, seen_from(b_from_a, in_a));
  EXPECT_NEAR(found.rms_m, 0.0, 1e-9);
  const Pose2 off = found.a_from_b * b_from_a;
  EXPECT_NEAR(off.translation().norm(), 0.0, 1e-9);
  EXPECT_NEAR(off.heading, 0.0, 1e-9);
}

TEST(ComparedPoses, AWrongScaleShowsUnlessItIsFitted) {
  const std::vector<Pose2> in_a = bending_way();
  const std::vector<Pose2> in_b = seen_from({1.0, 1.0, -0.7}, in_a, 1.05);
  EXPECT_GT(aligned(in_a, in_b).rms_m, 0.03);
  const Alignment fitted = aligned_with_scale(in_a, in_b);
  EXPECT_NEAR(fitted.rms_m, 0.0, 1e-9);
  EXPECT_NEAR(fitted.scale, 1.0 / 1.05, 1e-9);
}

TEST(ComparedPoses, HeadingsOfAnotherMountAreTurnedByTheirMean) {
  const std::vector<Pose2> in_a = bending_way();
  std::vector<Pose2> in_b = seen_from({0.0, 0.0, 0.4}, in_a);
  for (Pose2& pose : in_b) pose.heading = wrap_angle(pose.heading + 3.0);
  EXPECT_NEAR(heading_rms_rad(in_a, laid_in_a(in_a, in_b)), 0.0, 1e-9);
  in_b.front().heading += 0.3;
  EXPECT_NEAR(heading_rms_rad(in_a, laid_in_a(in_a, in_b)), 0.3 / std::sqrt(30.0), 0.005);
}

TEST(ComparedPoses, ARelationIsOffByMetresOrByItsHeading) {
  const Pose2 truth{1.0, 2.0, 3.1};
  EXPECT_FALSE(is_off(truth * Pose2{0.09, 0.0, 0.0}, truth, 0.1, 0.05));
  EXPECT_TRUE(is_off(truth * Pose2{0.08, 0.08, 0.0}, truth, 0.1, 0.05));
  EXPECT_TRUE(is_off(truth * Pose2{0.0, 0.0, -0.06}, truth, 0.1, 0.05));
}

}  // namespace
}  // namespace weft::evaluate::ceiling
