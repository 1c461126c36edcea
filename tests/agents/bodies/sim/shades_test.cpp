#include "agents/bodies/sim/shades.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace weft::agents::sim {
namespace {

constexpr float kFine = 0.001F;

float left_at(Shades& shades, float x, float y, double time_s, float apart_m = kFine) {
  shades.look_around(static_cast<double>(x), static_cast<double>(y), time_s);
  float left = -1.0F;
  shades.shadows({{&x, 1}, {&y, 1}, {&apart_m, 1}}, {&left, 1});
  return left;
}

float wet_at(Shades& shades, float x, float y) {
  shades.look_around(static_cast<double>(x), static_cast<double>(y), 0.0);
  float wet = -1.0F;
  shades.wetness({{&x, 1}, {&y, 1}, {&kFine, 1}}, {&wet, 1});
  return wet;
}

Change with_shadow() {
  CastShadow shadow;
  shadow.site_from_shadow = {5.0, 3.0, std::numbers::pi / 2};
  shadow.length_m = 2.0;
  shadow.width_m = 1.0;
  shadow.depth = 0.6;
  Change change;
  change.shadows.push_back(shadow);
  return change;
}

TEST(Shades, AShadowTakesItsShareWithinItsRectangle) {
  Shades shades(with_shadow());
  EXPECT_NEAR(left_at(shades, 5.0F, 3.0F, 0.0), 0.4F, 1e-6F);
  EXPECT_NEAR(left_at(shades, 5.4F, 3.9F, 0.0), 0.4F, 1e-6F);  // its length lies along y
  EXPECT_EQ(left_at(shades, 5.6F, 3.0F, 0.0), 1.0F);
  EXPECT_EQ(left_at(shades, 5.0F, 4.1F, 0.0), 1.0F);
  EXPECT_NEAR(left_at(shades, 5.5F, 3.0F, 0.0), 0.7F, 1e-4F);  // the middle of the rim
}

TEST(Shades, NoRimIsSharperThanThePointsLieApart) {
  Shades shades(with_shadow());
  EXPECT_EQ(left_at(shades, 5.6F, 3.0F, 0.0), 1.0F);
  EXPECT_LT(left_at(shades, 5.6F, 3.0F, 0.0, 0.4F), 0.95F);
}

TEST(Shades, AMovingShadowSwingsAlongItsLengthAtItsSpeed) {
  Change change = with_shadow();
  change.shadows[0].travel_m = 4.0;
  change.shadows[0].speed_m_s = 0.5;
  Shades shades(change);
  EXPECT_LT(left_at(shades, 5.0F, 3.0F, 0.0), 0.5F);
  // A quarter of its swing later it is 2 m further on, three quarters later 2 m behind.
  const double period_s = std::numbers::pi * 4.0 / 0.5;
  EXPECT_EQ(left_at(shades, 5.0F, 3.0F, period_s / 4), 1.0F);
  EXPECT_LT(left_at(shades, 5.0F, 5.0F, period_s / 4), 0.5F);
  EXPECT_LT(left_at(shades, 5.0F, 1.0F, 3 * period_s / 4), 0.5F);
  // In the middle it moves 5 cm in a tenth of a second: its end comes to what was the middle of its rim's dark side.
  EXPECT_NEAR(left_at(shades, 5.0F, 4.0F, 0.0), 0.7F, 1e-3F);
  EXPECT_NEAR(left_at(shades, 5.0F, 4.05F, 0.1), 0.7F, 1e-2F);
}

TEST(Shades, AWetAreaHasAnUnevenRim) {
  Change change;
  change.wet.push_back({2.0, 2.0, 1.0});
  Shades shades(change);
  EXPECT_EQ(wet_at(shades, 2.0F, 2.0F), 1.0F);
  EXPECT_EQ(wet_at(shades, 3.4F, 2.0F), 0.0F);
  int wet = 0;
  for (int i = 0; i < 60; ++i) {
    const double angle = i * 2.0 * std::numbers::pi / 60;
    wet +=
        wet_at(shades, static_cast<float>(2.0 + std::cos(angle)), static_cast<float>(2.0 + std::sin(angle))) > 0.5F;
  }
  EXPECT_GT(wet, 15);
  EXPECT_LT(wet, 45);
}

TEST(Shades, WhatIsFarCostsNothing) {
  Change change = with_shadow();
  change.wet.push_back({2.0, 2.0, 1.0});
  Shades shades(change);
  shades.look_around(100.0, 0.0, 0.0);
  EXPECT_FALSE(shades.any_shadow());
  EXPECT_FALSE(shades.any_wet());
}

}  // namespace
}  // namespace weft::agents::sim
