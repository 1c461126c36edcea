#include "agents/methods/ceiling/height.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace weft::agents {
namespace {

const HeightPrior kPrior = height_prior(CeilingConfig{}, 6.4, 0.6);

TEST(CornerHeight, IsTheCeilingsOrHangsBelowOrIsNone) {
  const auto on = height_of(kPrior, {6.38, 1.0 / (0.05 * 0.05)});
  ASSERT_TRUE(on);
  EXPECT_NEAR(on->above_floor_m, 6.4, 0.02);
  const auto hangs = height_of(kPrior, {5.3, 1.0 / (0.05 * 0.05)});
  ASSERT_TRUE(hangs);
  EXPECT_NEAR(hangs->above_floor_m, 5.3, 0.02);
  EXPECT_LT(hangs->sigma_m, 0.06);
  EXPECT_FALSE(height_of(kPrior, {7.5, 1.0 / (0.05 * 0.05)})) << "nothing is above a ceiling";
  EXPECT_FALSE(height_of(kPrior, {0.5, 1.0 / (0.05 * 0.05)})) << "nor a mast part of it";
  const auto unknown = height_of(kPrior, {});
  ASSERT_TRUE(unknown);
  EXPECT_GT(unknown->sigma_m, 0.4) << "what nobody has told may hang";
}

TEST(Gauge, IsTheHighestOfTheFrequentHeights) {
  // At a scale that is 10 % off, ceiling and lamps: more of the lamps.
  std::vector<ToldHeight> told;
  const auto seen_at = [](double height) { return 0.6 + (height - 0.6) * 1.1; };
  for (int i = 0; i < 30; ++i) told.push_back({seen_at(6.4) + 0.003 * (i % 7), 400.0});
  for (int i = 0; i < 40; ++i) told.push_back({seen_at(5.5) + 0.003 * (i % 7), 400.0});
  told.push_back({seen_at(7.4), 400.0});
  EXPECT_NEAR(gauge_factor(told, 6.4, 0.6), 1.0 / 1.1, 0.01);
  EXPECT_EQ(gauge_factor(std::vector<ToldHeight>(3, {5.0, 400.0}), 6.4, 0.6), 1.0);
}

}  // namespace
}  // namespace weft::agents
