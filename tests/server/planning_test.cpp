#include "server/dispatcher/planning.hpp"

#include <gtest/gtest.h>

namespace weft::server::test {
namespace {
using namespace std::chrono_literals;

TEST(BetweenPlans, AFewRobotsArePlannedForTenTimesASecond) {
  EXPECT_EQ(least_between_plans(0), 100ms);
  EXPECT_EQ(least_between_plans(20), 100ms);
}

TEST(BetweenPlans, TheMoreRobotsTheLongerUpToASecond) {
  EXPECT_EQ(least_between_plans(50), 250ms);
  EXPECT_EQ(least_between_plans(200), 1s);
  EXPECT_EQ(least_between_plans(100'000), 1s);
}

}  // namespace
}  // namespace weft::server::test
