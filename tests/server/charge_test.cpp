#include "server/dispatcher/charge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr SteadyTime kStart{1000s};

TEST(ChargeLevels, AreRefusedOutOfOrder) {
  EXPECT_TRUE(check(ChargeLevels{}));
  EXPECT_THAT(check(ChargeLevels{.critical = 0.3}).error().message, HasSubstr("charge_low_percent is 25"));
  EXPECT_THAT(check(ChargeLevels{.enough = 0.2}).error().message, HasSubstr("charge_enough_percent is 20"));
  EXPECT_THAT(check(ChargeLevels{.full = 1.2}).error().message, HasSubstr("charge_full_percent is 120"));
  EXPECT_THAT(check(ChargeLevels{.range_m = 0.0}).error().message, HasSubstr("charge_range_m is 0"));
}

TEST(ChargeLevels, AWayTakesItsShareAndTheReserve) {
  EXPECT_NEAR(share_for(ChargeLevels{.range_m = 1000.0}, 100.0), 0.15, 1e-12);
}

struct WatchTest : testing::Test {
  void say(const RobotId& robot, double share, bool is_charging = false) {
    watch.take(robot, share, is_charging, now += 5s);
  }
  RobotId r1 = robot_id(1), r2 = robot_id(2), r3 = robot_id(3);
  SteadyTime now = kStart;
  ChargeWatch watch{ChargeLevels{}};
};

TEST_F(WatchTest, WhoHasNotSaidItIsInNoQueueAndTakesGoals) {
  EXPECT_FALSE(watch.percent(r1));
  EXPECT_FALSE(watch.is_recharging(r1));
  EXPECT_TRUE(watch.is_full(r1)) << "it may make way at a charger";
  watch.fell_short(r1, now);
  EXPECT_THAT(watch.queue(), IsEmpty());
}

TEST_F(WatchTest, WhoIsLowIsToChargeAndTakesGoalsUntilItGoes) {
  say(r1, 0.26);
  EXPECT_THAT(watch.queue(), IsEmpty());
  say(r1, 0.25);
  EXPECT_THAT(watch.queue(), ElementsAre(r1));
  EXPECT_FALSE(watch.is_recharging(r1));
  watch.sent(r1);
  EXPECT_TRUE(watch.is_recharging(r1));
}

TEST_F(WatchTest, WhoIsCriticalTakesNoGoals) {
  say(r1, 0.1);
  EXPECT_TRUE(watch.is_critical(r1));
  EXPECT_TRUE(watch.is_recharging(r1));
}

TEST_F(WatchTest, WhoChargesTakesGoalsOnceItHasEnough) {
  say(r1, 0.2);
  watch.sent(r1);
  say(r1, 0.4, true);
  say(r1, 0.59, true);
  EXPECT_TRUE(watch.is_recharging(r1));
  say(r1, 0.6, true);
  EXPECT_FALSE(watch.is_recharging(r1));
  EXPECT_THAT(watch.queue(), IsEmpty());
  EXPECT_FALSE(watch.is_full(r1));
  say(r1, 0.95, true);
  EXPECT_TRUE(watch.is_full(r1));
}

TEST_F(WatchTest, WhoIsLedOffItsChargerBeforeItHasEnoughIsToChargeStill) {
  say(r1, 0.2);
  watch.sent(r1);
  say(r1, 0.4, true);
  say(r1, 0.4);
  EXPECT_THAT(watch.queue(), ElementsAre(r1));
}

TEST_F(WatchTest, CriticalOnesComeFirstThenWhoHasBeenLowForLongest) {
  say(r3, 0.2);
  say(r1, 0.22);
  say(r2, 0.3);
  EXPECT_THAT(watch.queue(), ElementsAre(r3, r1));
  say(r2, 0.05);
  EXPECT_THAT(watch.queue(), ElementsAre(r2, r3, r1));
}

TEST_F(WatchTest, WhoseChargeDidNotCoverAGoalIsToCharge) {
  say(r1, 0.5);
  watch.fell_short(r1, now);
  EXPECT_THAT(watch.queue(), ElementsAre(r1));
  EXPECT_FALSE(watch.is_recharging(r1)) << "it may take a shorter one meanwhile";
}

TEST_F(WatchTest, PercentAreWhole) {
  say(r1, 0.29);
  EXPECT_EQ(watch.percent(r1), 29);
  say(r1, 0.2999);
  EXPECT_EQ(watch.percent(r1), 29);
}

TEST(ServiceSettings, ChargeLevelsAreCheckedAtTheStart) {
  const auto disk = std::make_shared<storage::MemoryDisk>();
  const auto store = storage::make_memory_store(disk);
  ServiceConfig config;
  config.self = robot_id(255);
  config.charge.low = 0.9;
  const auto started = start(config, *store, Random(1), {.steady = kStart, .wall = WallTime(5000s)});
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message, HasSubstr("charge_enough_percent"));
}

}  // namespace
}  // namespace weft::server::test
