#include "agents/methods/ceiling/height.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace weft::agents
