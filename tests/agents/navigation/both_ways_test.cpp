// Edges that are driven against the direction in which they were taught, too.
#include "agents/navigation/route_facing.hpp"
#include "agents/navigation/spots.hpp"
#include "tests/agents/navigation/roamer_fleet.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::NavigatedRobot;

std::vector<RoutePose> facing(const std::vector<Pose2>& taught) {
  std::vector<RoutePose> poses;
  for (std::uint32_t i = 0; i < taught.size(); ++i) poses.push_back({i, taught[i]});
  face_travel(poses);
  return poses;
}

TEST(FaceTravel, AgainstWhatWasTaughtTheRobotFacesTheWayItDrives) {
  for (const RoutePose& pose : facing({{0.0, 0.0, 3.1}, {0.5, 0.0, -3.1}, {1.0, 0.0, 3.1}})) {
    EXPECT_NEAR(pose.robot_from_place.heading, 0.0, 0.05) << pose.index;
    EXPECT_EQ(pose.turn_rad, 0.0);
  }
}

TEST(FaceTravel, AsItWasTaughtItStays) {
  const std::vector<Pose2> taught = Course({0, 0, 0}).straight(1.0).turn(0.5, M_PI / 2).straight(1.0).poses;
  const std::vector<RoutePose> poses = facing(taught);
  for (std::size_t i = 0; i < taught.size(); ++i) EXPECT_EQ(poses[i].robot_from_place, taught[i]) << i;
}

TEST(FaceTravel, AStitchThatStepsBackOrAsideTurnsNobody) {
  for (const RoutePose& pose :
       facing({{0.0, 0.0, 0.1}, {0.5, 0.0, 0.0}, {0.4, 0.1, 0.05}, {0.9, 0.1, 0.0}, {1.4, 0.1, 0.0}})) {
    EXPECT_NEAR(pose.robot_from_place.heading, 0.0, 0.11) << pose.index;
    EXPECT_EQ(pose.turn_rad, 0.0);
  }
}

TEST(FaceTravel, AShortcutThatLeadsOffSharplyBeginsAtACorner) {
  const std::vector<RoutePose> poses = facing({{0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, {0.5, 3.0, M_PI}, {0.0, 3.0, M_PI}});
  EXPECT_NEAR(poses[1].robot_from_place.heading, 0.0, 1e-9);
  EXPECT_NEAR(poses[1].turn_rad, M_PI / 2, 1e-9);
  EXPECT_NEAR(heading_on(poses[1]), M_PI / 2, 1e-9);
  EXPECT_NEAR(poses[2].robot_from_place.heading, M_PI / 2, 1e-9);
  EXPECT_NEAR(poses[2].turn_rad, M_PI / 2, 1e-9);
}

TEST(FaceTravel, AtABluntCornerItFacesBetweenBothWays) {
  const std::vector<RoutePose> poses = facing({{0.0, 0.0, 2.0}, {1.0, 0.0, 2.0}, {1.8, 0.6, 2.0}});
  EXPECT_NEAR(poses[1].robot_from_place.heading, 0.5 * std::atan2(0.6, 0.8), 1e-9);
  EXPECT_EQ(poses[1].turn_rad, 0.0);
}

TEST(NextSpot, ACornerIsDueUntilTheRobotHasTurnedThere) {
  RouteAround around;
  around.poses = {{0, {-0.5, 0.0, 0.0}}, {1, {0.0, 0.0, 0.0}, M_PI / 2}, {2, {0.0, 1.0, M_PI / 2}}};
  around.nearest = 1;
  ASSERT_TRUE(next_spot(around));
  EXPECT_EQ(next_spot(around)->first, 1U);
  around.poses = {{0, {0.0, 0.5, -M_PI / 2}}, {1, {0.02, 0.0, -M_PI / 2}, M_PI / 2}, {2, {1.0, 0.0, 0.0}}};
  EXPECT_FALSE(next_spot(around));
  around.nearest = 0;
  EXPECT_FALSE(next_spot(around)) << "another place is a little nearer";
}

/// Drives marks by the default steering, in either direction.
class MarksBothWays : public MarksMethod {
 public:
  static constexpr bool drives_both_ways = true;
  MarksBothWays() : MarksMethod(MarksConfig{}) {}
};
static_assert(drives_both_ways<MarksBothWays>() && !drives_both_ways<MarksMethod>());

class BothWays : public MarksFleet {
 protected:
  void SetUp() override { teach(first, Course({5, 5, 0}).straight(3.0).turn(1.0, M_PI / 2).straight(2.5).poses); }
  std::unique_ptr<Navigator> navigator() const override { return make_navigator(MarksBothWays{}, navigation); }

  /// Drives from the last place back to the first one.
  void drive_back(double start_turned_rad) {
    const PlaceId from = last_of(first);
    const PlaceId goal{first, 0};
    NavigatedRobot robot = localised_at(truth.at(from) * Pose2{0.0, 0.0, start_turned_rad}, from, 2);
    const Route route = server.route(from, goal, method());
    double turned_rad = 0.0;  // before it drives for the first time
    bool drives = false;
    std::uint32_t last_freed = 0;
    const Driven driven = drive(robot, route, 1.0, [&](const Navigated& navigated) {
      drives = drives || navigated.command.linear_m_s > 0.0;
      if (!drives) turned_rad += std::abs(navigated.command.angular_rad_s) * 0.1;
      EXPECT_GE(navigated.command.linear_m_s, -0.05) << "it creeps back at most, at the goal";
      EXPECT_GE(navigated.route_freed, last_freed);
      last_freed = navigated.route_freed;
    });
    EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
    EXPECT_EQ(driven.last.route_at, route.places.size() - 1);
    EXPECT_GT(last_freed + 8, route.places.size());
    EXPECT_LT(driven.worst_lateral_m, 0.08);
    EXPECT_NEAR(turned_rad, std::abs(wrap_angle(M_PI - start_turned_rad)), 0.4);
    EXPECT_LT(test::distance(robot.world_from_robot(), truth.at(goal)), 0.05);
    EXPECT_LT(test::turned(robot.world_from_robot(), truth.at(goal)), 0.05) << "as the goal was taught";
  }
};

TEST_F(BothWays, WhatIsTaughtCanBeDrivenInEitherDirection) {
  for (const Edge& edge : server.snapshot().experience(first)->chain) EXPECT_EQ(edge.drivable, Drivable::both);
}

TEST_F(BothWays, ARobotThatFacesTheOtherWayTurnsFirstAndDrivesBack) {
  drive_back(0.0);
}

TEST_F(BothWays, OneThatFacesItsWayDrivesBackAtOnce) {
  drive_back(M_PI);
}

TEST_F(BothWays, TheReleasedPointIsKeptOnTheWayBackToo) {
  const PlaceId from = last_of(first);
  NavigatedRobot robot = localised_at(truth.at(from), from, 3);
  Route route = server.route(from, {first, 0}, method());
  route.released = 9;
  const Pose2 end = truth.at(route.places[9]);
  double beyond_m = -1.0;  // along the way back
  const Driven driven = drive(robot, route, 1.0, [&](const Navigated&) {
    beyond_m = std::max(beyond_m, -(end.inverse() * robot.world_from_robot()).x);
  });
  EXPECT_EQ(driven.last.reason, "waits_for_release");
  EXPECT_LT(beyond_m, 0.01);
  EXPECT_GT(beyond_m, -0.06);
}

using RoamingBothWays = RoamerFleet;

TEST_F(RoamingBothWays, ComesAndGoes) {
  teach(first, Course({5, 5, 0}).straight(4.0).turn(1.0, M_PI / 2).straight(2.0).poses);
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  const Driven there = drive(robot, route_to_last({first, 0}));
  EXPECT_EQ(there.last.following, Following::arrived) << there.last.reason;
  const Driven back = drive(robot, server.route(last_of(first), {first, 0}, method()));
  EXPECT_EQ(back.last.following, Following::arrived) << back.last.reason;
  EXPECT_LT(test::distance(robot.world_from_robot(), truth.at({first, 0})), 0.07);
  EXPECT_LT(test::turned(robot.world_from_robot(), truth.at({first, 0})), 0.07);
}

}  // namespace
}  // namespace weft::agents
