#include "agents/methods/ceiling/gauge.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace weft::agents {
namespace {

constexpr double kCameraM = 0.6;
const HeightPrior kCeiling = height_prior(CeilingConfig{}, 6.4, kCameraM);

/// Adds heights of things that hang at `height_m`, as a motion tells them that is too long by a factor.
void add(int count, double height_m, double too_long, std::vector<ToldHeight>& told) {
  for (int i = 0; i < count; ++i)
    told.push_back({kCameraM + too_long * (height_m - kCameraM) + 0.006 * (i % 7 - 3), 200.0});
}

TEST(Gauge, PutsNothingAboveTheCeilingThoughMoreHangsBelowIt) {
  std::vector<ToldHeight> told;
  add(30, 6.4, 1.1, told);
  add(40, 5.5, 1.1, told);
  told.push_back({7.9, 400.0});
  EXPECT_NEAR(gauge_factor(told, kCeiling, kCameraM, {}), 1.0 / 1.1, 0.01);
  EXPECT_EQ(gauge_factor(std::vector<ToldHeight>(3, {5.0, 400.0}), kCeiling, kCameraM, {}), 1.0);
}

TEST(Gauge, IsNotThatOfLampsWhereWheelsSayOtherwise) {
  std::vector<ToldHeight> told;
  add(20, 5.5, 1.0, told);
  EXPECT_GT(gauge_factor(told, kCeiling, kCameraM, {}), 1.1) << "else nothing was tested";
  EXPECT_NEAR(gauge_factor(told, kCeiling, kCameraM, {1.03, 0.035}), 1.0, 0.08);
}

TEST(Gauge, ThatIsHeldIsLeftWhenACeilingAppearsAboveIt) {
  std::vector<ToldHeight> told;
  add(30, 5.5, 1.18, told);  // lamps, which were taken for the ceiling
  EXPECT_EQ(gauge_factor(told, kCeiling, kCameraM, {0.9, 0.035, true}), 1.0);
  add(60, 6.4, 1.18, told);
  EXPECT_NEAR(gauge_factor(told, kCeiling, kCameraM, {0.87, 0.035, true}), 1.0 / 1.18, 0.02);
}

}  // namespace
}  // namespace weft::agents
