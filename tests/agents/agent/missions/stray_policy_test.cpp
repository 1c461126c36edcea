#include "agents/agent/missions/stray_policy.hpp"

#include <gtest/gtest.h>

namespace weft::agents::test {
namespace {

GoalId a_goal(std::uint8_t number) {
  GoalId goal;
  goal.bytes[0] = number;
  return goal;
}

TEST(StrayPolicy, OnlyARouteThatLiesElsewhereCounts) {
  StrayPolicy policy;
  policy.look(Following::stopped, "blocked");
  EXPECT_FALSE(policy.strays());
  policy.look(Following::waiting, "off_route");
  EXPECT_FALSE(policy.strays());
  policy.look(Following::stopped, "off_route");
  EXPECT_TRUE(policy.strays());
  policy.look(Following::driving, "");
  EXPECT_FALSE(policy.strays());
  policy.look(Following::stopped, "route_not_joined");
  EXPECT_TRUE(policy.strays());
}

TEST(StrayPolicy, GoalsRouteIsGivenBackThreeTimes) {
  StrayPolicy policy;
  EXPECT_FALSE(policy.gives_back(a_goal(1))) << "it does not stray";
  for (int times = 1; times <= 3; ++times) {
    policy.look(Following::stopped, "off_route");
    EXPECT_TRUE(policy.gives_back(a_goal(1))) << times;
    EXPECT_FALSE(policy.strays());
  }
  policy.look(Following::stopped, "off_route");
  EXPECT_FALSE(policy.gives_back(a_goal(1)));
  EXPECT_TRUE(policy.strays()) << "it still does";
  EXPECT_TRUE(policy.gives_back(a_goal(2))) << "another goal begins anew";
}

}  // namespace
}  // namespace weft::agents::test
