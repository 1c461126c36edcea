#include <gtest/gtest.h>

#include "agents/navigation/route_ahead.hpp"

namespace weft::agents {
namespace {

bool crosses(const Pose2& a_from_b) {
  return can_cross(StitchConfig{}, Metric2{a_from_b, Eigen::Matrix3d::Zero()});
}

TEST(Crossing, WaysThatRunSideBySideCanBeChanged) {
  EXPECT_TRUE(crosses({0.05, 0.0, 0.02}));
  EXPECT_TRUE(crosses({-0.10, 0.15, 0.0}));  // behind: what follows it lies ahead
  EXPECT_TRUE(crosses({0.10, -0.30, 0.10}));
  EXPECT_TRUE(crosses({0.0, 0.3, -0.3}));  // it comes nearer
}

TEST(Crossing, AWayThatTurnsOffBesideTheRobotCannotBeReached) {
  EXPECT_FALSE(crosses({-0.36, -0.21, -0.47}));
  EXPECT_FALSE(crosses({0.0, 0.3, 0.3}));
  EXPECT_FALSE(crosses({0.0, 0.55, 0.0}));
}

TEST(Crossing, ItHoldsInBothDirections) {
  for (double y = -0.6; y <= 0.6; y += 0.1) {
    for (double heading = -0.5; heading <= 0.5; heading += 0.1) {
      const Pose2 a_from_b{-0.1, y, heading};
      EXPECT_EQ(crosses(a_from_b), crosses(a_from_b.inverse())) << y << " " << heading;
    }
  }
}

TEST(Crossing, FarOrTurnedAroundIsNoWay) {
  EXPECT_FALSE(crosses({0.7, 0.0, 0.0}));
  EXPECT_FALSE(crosses({0.0, 0.0, 0.6}));
  EXPECT_FALSE(crosses({0.0, 0.0, 3.1}));
}

}  // namespace
}  // namespace weft::agents
