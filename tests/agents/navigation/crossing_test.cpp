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

TEST(PathAhead, AWayThatLeadsOffBesideTheRobotIsBentIntoAllTheSame) {
  // As met: a place at the end of a short run, stitched to a way that runs off to the right of it.
  const std::vector<Pose2> met = {{-0.014, 0.000, 0.001},  {-0.027, -0.100, -0.152}, {0.184, -0.155, -0.285},
                                  {0.392, -0.225, -0.369}, {0.592, -0.305, -0.384},  {0.798, -0.379, -0.341},
                                  {1.038, -0.439, -0.226}, {1.254, -0.470, -0.099},  {1.419, -0.483, 0.012},
                                  {1.636, -0.456, 0.172},  {1.845, -0.403, 0.334},   {2.039, -0.315, 0.479},
                                  {2.226, -0.199, 0.631},  {2.394, -0.058, 0.775},   {2.540, 0.105, 0.902}};
  Route route;
  RouteAround around;
  for (std::uint32_t i = 0; i < met.size(); ++i) around.poses.push_back({i, met[i]});
  route.places.resize(40);
  route.relations.resize(39);
  route.released = 39;
  const PathAhead ahead = path_ahead(NavigationConfig{}, route, around);
  ASSERT_GT(ahead.robot_from_path.size(), 3U);
  EXPECT_FALSE(ahead.reaches_end);
  for (std::size_t i = 1; i < ahead.robot_from_path.size(); ++i) {
    EXPECT_GT(ahead.robot_from_path[i].x, ahead.robot_from_path[i - 1].x);
  }
}

TEST(Crossing, FarOrTurnedAroundIsNoWay) {
  EXPECT_FALSE(crosses({0.7, 0.0, 0.0}));
  EXPECT_FALSE(crosses({0.0, 0.0, 0.6}));
  EXPECT_FALSE(crosses({0.0, 0.0, 3.1}));
}

}  // namespace
}  // namespace weft::agents
