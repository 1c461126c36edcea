#include "agents/bodies/battery.hpp"

#include <gtest/gtest.h>

namespace weft::agents::test {
namespace {

const BatterySetup kSetup{.share = 0.5,
                          .drains_per_m = 0.001,
                          .drains_per_s = 0.0001,
                          .charges_per_s = 0.01,
                          .chargers = {{10.0, 0.0}},
                          .reach_m = 0.5};

TEST(Battery, DrainsByWayAndByTime) {
  Battery battery(kSetup);
  battery.advance(2.0, 10.0, {0.0, 0.0});
  EXPECT_NEAR(battery.charge().share, 0.5 - 0.002 - 0.001, 1e-12);
  EXPECT_FALSE(battery.charge().is_charging);
  battery.advance(-2.0, 10.0, {0.0, 0.0});
  EXPECT_NEAR(battery.charge().share, 0.5 - 0.006, 1e-12) << "backwards, too";
}

TEST(Battery, FillsWhereItStandsAtACharger) {
  Battery battery(kSetup);
  battery.advance(0.0, 10.0, {10.0, 0.4});
  EXPECT_TRUE(battery.charge().is_charging);
  EXPECT_NEAR(battery.charge().share, 0.6, 1e-12);
  EXPECT_NEAR(battery.charge().minutes.value(), 0.4 / 0.01 / 60.0, 1e-9);
  battery.advance(0.0, 1000.0, {10.0, 0.4});
  EXPECT_EQ(battery.charge().share, 1.0);
}

TEST(Battery, WhoDrivesByOrStandsElsewhereIsNotCharged) {
  Battery battery(kSetup);
  battery.advance(1.0, 2.0, {10.0, 0.0});
  EXPECT_FALSE(battery.charge().is_charging);
  battery.advance(0.0, 2.0, {10.0, 0.6});
  EXPECT_FALSE(battery.charge().is_charging);
}

TEST(Battery, IsEmptyInTheEndAndNoLess) {
  Battery battery(kSetup);
  battery.advance(1e4, 10.0, {0.0, 0.0});
  EXPECT_TRUE(battery.is_empty());
  EXPECT_EQ(battery.charge().share, 0.0);
}

}  // namespace
}  // namespace weft::agents::test
