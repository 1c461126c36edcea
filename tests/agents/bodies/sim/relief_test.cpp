#include "agents/bodies/sim/relief.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace weft::agents::sim {
namespace {

constexpr double kPeakM = 0.002;
constexpr double kStepM = 0.01;

TEST(Relief, StaysWithinItsPeakAndIsMostlyNearerThePlane) {
  const Relief relief(kPeakM, 1);
  double squares = 0.0;
  double most = 0.0;
  int count = 0;
  for (double x = -20.0; x < 20.0; x += 0.17) {
    for (double y = -20.0; y < 20.0; y += 0.19) {
      const double height = relief.height_m(x, y);
      most = std::max(most, std::abs(height));
      squares += height * height;
      ++count;
    }
  }
  EXPECT_LE(most, kPeakM);
  EXPECT_GT(most, 0.95 * kPeakM);
  EXPECT_NEAR(std::sqrt(squares / count) / kPeakM, 0.63, 0.03);
}

TEST(Relief, IsAFunctionOfPlaceAndSeed) {
  const Relief relief(kPeakM, 7);
  EXPECT_EQ(relief.height_m(3.1, -900.7), Relief(kPeakM, 7).height_m(3.1, -900.7));
  EXPECT_NE(relief.height_m(3.1, -900.7), Relief(kPeakM, 8).height_m(3.1, -900.7));
  EXPECT_NEAR(Relief(5 * kPeakM, 7).height_m(3.1, 2.0), 5 * relief.height_m(3.1, 2.0), 1e-12);
}

TEST(Relief, IsSmoothAndRarelySteep) {
  const Relief relief(kPeakM, 3);
  int steeper = 0;
  int count = 0;
  double squares = 0.0;
  for (double y = 0.0; y < 40.0; y += 0.31) {
    for (double x = 0.0; x < 40.0; x += 0.29) {
      const double slope = (relief.height_m(x + kStepM, y) - relief.height_m(x, y)) / kStepM;
      const double next = (relief.height_m(x + 2 * kStepM, y) - relief.height_m(x + kStepM, y)) / kStepM;
      EXPECT_LT(std::abs(next - slope), 0.2 * relief.steep()) << "at " << x << ", " << y;
      steeper += std::abs(slope) > relief.steep();
      squares += slope * slope;
      ++count;
    }
  }
  EXPECT_LT(steeper, count / 1000);
  EXPECT_NEAR(std::sqrt(squares / count), 0.0043, 0.0005) << "4 mm a metre on a floor uneven by 2 mm";
}

TEST(Relief, HasNoWaveShorterThanThreeDecimetres) {
  const Relief relief(kPeakM, 5);
  // Between points so near each other that every wave is sampled often, a parabola tells the height in the middle.
  double most = 0.0;
  for (double x = 0.0; x < 50.0; x += 0.013) {
    const auto at = [&](double ahead) { return relief.height_m(x + ahead, 4.0); };
    const double told = (-at(-0.06) + 4.0 * at(-0.03) + 4.0 * at(0.03) - at(0.06)) / 6.0;
    most = std::max(most, std::abs(at(0.0) - told));
  }
  EXPECT_LT(most, 0.01 * kPeakM);
}

TEST(Relief, OfASiteIsThereWhenTheFloorIsUneven) {
  Site site;
  EXPECT_FALSE(relief_of(site));
  site.disturbances.unevenness_m = kPeakM;
  site.floor.seed = 12;
  const auto relief = relief_of(site);
  ASSERT_TRUE(relief);
  EXPECT_EQ(relief->height_m(1.0, 2.0), Relief(kPeakM, 12).height_m(1.0, 2.0));
}

}  // namespace
}  // namespace weft::agents::sim
