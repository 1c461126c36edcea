#include "agents/agent/power_reporter.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

const SteadyTime kStart = SteadyTime{} + 1h;

TEST(PowerReporter, ABodyThatDoesNotKnowItsChargeSaysNothing) {
  PowerReporter power;
  power.take(std::nullopt, kStart);
  EXPECT_FALSE(power.due(kStart + 1h));
  EXPECT_FALSE(power.next());
}

TEST(PowerReporter, SaysEachFiveSecondsWhatTheBatteryHolds) {
  PowerReporter power;
  power.take(Charge{.share = 0.5}, kStart);
  const std::optional<msg::RobotPower> first = power.due(kStart);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->share, 0.5);
  EXPECT_FALSE(first->is_charging);
  EXPECT_FALSE(first->minutes);
  power.take(Charge{.share = 0.4}, kStart + 1s);
  EXPECT_FALSE(power.due(kStart + 4900ms)) << "another share alone is not told at once";
  EXPECT_EQ(power.next(), kStart + 5s);
  EXPECT_EQ(power.due(kStart + 5s).value().share, 0.4);
}

TEST(PowerReporter, ThatItBeginsToChargeIsSaidAtOnce) {
  PowerReporter power;
  power.take(Charge{.share = 0.5}, kStart);
  ASSERT_TRUE(power.due(kStart));
  power.take(Charge{.share = 0.5, .is_charging = true, .minutes = 20.0}, kStart + 1s);
  const std::optional<msg::RobotPower> charging = power.due(kStart + 1s);
  ASSERT_TRUE(charging);
  EXPECT_TRUE(charging->is_charging);
  EXPECT_EQ(charging->minutes, 20.0);
}

TEST(PowerReporter, AnotherServerIsToldAtOnce) {
  PowerReporter power;
  power.take(Charge{.share = 0.5}, kStart);
  ASSERT_TRUE(power.due(kStart));
  power.server_restarted(kStart + 1s);
  EXPECT_TRUE(power.due(kStart + 1s));
}

}  // namespace
}  // namespace weft::agents::test
