#include "tests/agents/navigation/marks_fleet.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::NavigatedRobot;

class Follow : public MarksFleet {
 protected:
  void SetUp() override { teach(first, course()); }
  static std::vector<Pose2> course() {
    return Course({5, 5, 0}).straight(3.0).turn(1.0, M_PI / 2).straight(2.5).poses;
  }
  Route route_that_ends_at_place_7() {
    Route route = route_to_last({first, 0});
    route.places.resize(8);
    route.relations.resize(7);
    route.released = 7;
    return route;
  }
  /// Runs the robot for as long as it is stopped.
  Navigated stand(NavigatedRobot& robot) {
    Navigated navigated = run(robot, 1);
    for (int samples = 0; samples < 3000 && navigated.following == Following::stopped; ++samples) {
      navigated = run(robot, 1);
    }
    return navigated;
  }
  double beyond_m(const NavigatedRobot& robot, const PlaceId& place) const {
    return (truth.at(place).inverse() * robot.world_from_robot()).x;
  }
};

TEST_F(Follow, ArrivesAtTheGoalWithItsHeading) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  const Route route = route_to_last({first, 0});
  const Driven driven = drive(robot, route);
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_LT(test::distance(robot.world_from_robot(), truth.at(route.places.back())), 0.03);
  EXPECT_LT(test::turned(robot.world_from_robot(), truth.at(route.places.back())), 0.05);
  EXPECT_LT(driven.worst_lateral_m, 0.03);
  EXPECT_EQ(driven.last.route_at, route.places.size() - 1);
  EXPECT_EQ(driven.last.command, Twist{});
}

TEST_F(Follow, NeverPassesTheReleasedPlaceAndGoesOnWhenMoreIsReleased) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 3);
  Route route = route_to_last({first, 0});
  for (const std::uint32_t released : {8U, 9U, 20U}) {
    route.released = released;
    double worst = -1.0;
    const Driven driven = drive(robot, route, 1.0, [&](const Navigated& navigated) {
      worst = std::max(worst, beyond_m(robot, route.places[released]));
      EXPECT_LE(navigated.route_at, released);
      EXPECT_LE(navigated.route_freed, navigated.route_at);
    });
    EXPECT_EQ(driven.last.following, Following::waiting);
    EXPECT_EQ(driven.last.reason, "waits_for_release");
    EXPECT_LT(worst, 0.01);
    EXPECT_GT(worst, -0.06);
  }
  route.released = static_cast<std::uint32_t>(route.places.size() - 1);
  EXPECT_EQ(drive(robot, route).last.following, Following::arrived);
}

TEST_F(Follow, KeepsToTheLimitsOfItsRoute) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 6);
  Route route = route_to_last({first, 0});
  route.limits = {{8, 12, 0.2}};
  double fastest_within = 0.0;
  double fastest = 0.0;
  const Driven driven = drive(robot, route, 1.0, [&](const Navigated& navigated) {
    const double speed_m_s = navigated.command.linear_m_s;
    fastest = std::max(fastest, speed_m_s);
    if (navigated.route_at >= 8 && navigated.route_at <= 12) fastest_within = std::max(fastest_within, speed_m_s);
  });
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_GT(fastest, 0.45);
  EXPECT_LT(fastest_within, 0.25);
  EXPECT_GT(fastest_within, 0.1);
}

TEST_F(Follow, MoreReleasedInTimeIsDrivenWithoutAStop) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 4);
  Route route = route_to_last({first, 0});
  const auto end = static_cast<std::uint32_t>(route.places.size() - 1);
  route.released = 10;
  double slowest = 1.0;
  const Driven driven = drive(robot, route, 1.0, [&](const Navigated& navigated) {
    if (route.released < end && navigated.route_at + 6 >= route.released) {
      route.released = std::min(end, route.released + 3);
      robot.navigator().follow(route);
    }
    if (navigated.route_at > 5 && navigated.route_at + 8 < end) {
      slowest = std::min(slowest, navigated.command.linear_m_s);
    }
  });
  EXPECT_EQ(driven.last.following, Following::arrived);
  EXPECT_GT(slowest, 0.25);
}

TEST_F(Follow, WithdrawnReleaseStopsAtOnce) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 5);
  Route route = route_to_last({first, 0});
  robot.navigator().follow(route);
  run(robot, 45);
  const auto passed = static_cast<std::uint32_t>(3);
  ASSERT_GT(beyond_m(robot, route.places[passed]), 0.3);
  route.released = passed;
  ++route.version;
  robot.navigator().follow(route);
  Navigated navigated = robot.step(server.map());
  EXPECT_EQ(navigated.command, Twist{});
  navigated = run(robot, 20);
  EXPECT_EQ(navigated.command, Twist{});
  EXPECT_NE(navigated.following, Following::driving);
}

TEST_F(Follow, JoinsTheRouteFromBesideItsStart) {
  for (const double side : {1.0, -1.0}) {
    NavigatedRobot robot = localised_at(truth.at({first, 0}) * Pose2{0, 0.3 * side, 0.35 * side}, {first, 0}, 6);
    const Driven driven = drive(robot, route_to_last({first, 0}), 2.4);
    EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
    EXPECT_LT(driven.worst_lateral_m, 0.04);
  }
}

TEST_F(Follow, StartsWithTheNearestPlaceWhenItStandsFurtherOn) {
  NavigatedRobot robot = localised_at(truth.at({first, 7}), {first, 7}, 7);
  robot.navigator().follow(route_to_last({first, 0}));
  const Navigated navigated = run(robot, 3);
  EXPECT_EQ(navigated.following, Following::driving);
  EXPECT_GE(navigated.route_at, 6U);
  EXPECT_GE(navigated.command.linear_m_s, 0.0);
  EXPECT_LT(std::abs(navigated.command.angular_rad_s), 0.3);
}

TEST_F(Follow, TooFarFromTheRouteItStandsAndSaysSo) {
  NavigatedRobot robot = localised_at(truth.at({first, 25}), {first, 25}, 8);
  robot.navigator().follow(route_that_ends_at_place_7());
  const Navigated navigated = run(robot, 5);
  EXPECT_EQ(navigated.following, Following::stopped);
  EXPECT_EQ(navigated.reason, "off_route");
  EXPECT_EQ(navigated.command, Twist{});
}

TEST_F(Follow, TooFarFromTheRouteForLongItGivesUp) {
  NavigatedRobot robot = localised_at(truth.at({first, 25}), {first, 25}, 8);
  robot.navigator().follow(route_that_ends_at_place_7());
  const Navigated navigated = stand(robot);
  EXPECT_EQ(navigated.following, Following::failed);
  EXPECT_EQ(navigated.reason, "off_route");
  EXPECT_EQ(navigated.command, Twist{});
}

TEST_F(Follow, WhereItsRouteComesByBeyondWhatIsReleasedItGivesUp) {
  NavigatedRobot robot = localised_at(truth.at({first, 25}), {first, 25}, 8);
  Route route = route_to_last({first, 0});
  route.released = 5;
  robot.navigator().follow(route);
  const Navigated navigated = stand(robot);
  EXPECT_EQ(navigated.following, Following::failed);
  EXPECT_EQ(navigated.reason, "beyond_release");
  EXPECT_EQ(navigated.command, Twist{});
}

TEST_F(Follow, ANewVersionMidWayIsDrivenOnSmoothly) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 9);
  Route route = route_to_last({first, 0});
  robot.navigator().follow(route);
  double before = 0.0;
  for (int i = 0; i < 50; ++i) before = robot.step(server.map()).command.linear_m_s;
  // Planned anew from a place that the robot has passed.
  route = server.route({first, 5}, last_of(first), "marks");
  route.version = 2;
  robot.navigator().follow(route);
  const Navigated navigated = robot.step(server.map());
  EXPECT_EQ(navigated.following, Following::driving);
  EXPECT_NEAR(navigated.command.linear_m_s, before, 0.1);
  EXPECT_LT(std::abs(navigated.command.angular_rad_s), 0.2);
  EXPECT_EQ(drive(robot, route).last.following, Following::arrived);
}

TEST_F(Follow, ReportsWhatItsFootprintHasLeft) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 10);
  const Route route = route_to_last({first, 0});
  std::uint32_t last_freed = 0;
  drive(robot, route, 1.0, [&](const Navigated& navigated) {
    EXPECT_GE(navigated.route_freed, last_freed);
    last_freed = navigated.route_freed;
    for (std::uint32_t i = 0; i < navigated.route_freed; ++i) {
      EXPECT_GT(test::distance(truth.at(route.places[i]), robot.world_from_robot()),
                navigation.follow.footprint_radius_m);
    }
  });
  EXPECT_GT(last_freed + 6, route.places.size());
}

TEST_F(Follow, AGoalBesideWhichItStandsIsReached) {
  const PlaceId goal{first, 10};
  NavigatedRobot robot = localised_at(truth.at(goal) * Pose2{-0.02, 0.15, 0.2}, goal, 11);
  const Driven driven = drive(robot, server.route(goal, goal, "marks"));
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_LT(test::distance(robot.world_from_robot(), truth.at(goal)), 0.04);
  EXPECT_LT(test::turned(robot.world_from_robot(), truth.at(goal)), 0.05);
}

TEST_F(Follow, StopForgetsTheRoute) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 12);
  robot.navigator().follow(route_to_last({first, 0}));
  run(robot, 30);
  robot.navigator().stop();
  const Navigated navigated = run(robot, 1);
  EXPECT_EQ(navigated.command, Twist{});
  EXPECT_EQ(navigated.following, Following::none);
}

TEST_F(Follow, AnEndedRouteIsDrivenToItsReleasedPlaceOnly) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 13);
  Route route = route_to_last({first, 0});
  route.released = 6;
  route.ended = true;
  const Driven driven = drive(robot, route);
  EXPECT_EQ(driven.last.following, Following::waiting);
  EXPECT_EQ(driven.last.reason, "route_ended");
  EXPECT_NEAR(beyond_m(robot, route.places[6]), -0.02, 0.03);
}

TEST_F(Follow, WithoutABeliefItStands) {
  NavigatedRobot robot = robot_at(truth.at({first, 0}), 14);
  robot.navigator().follow(route_to_last({first, 0}));
  const Navigated navigated = run(robot, 5);
  EXPECT_EQ(navigated.following, Following::stopped);
  EXPECT_EQ(navigated.reason, "not_localised");
  EXPECT_EQ(navigated.command, Twist{});
}

TEST_F(Follow, PlacesThatTheWindowLacksAreFollowedByTheRoutesRelations) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 15);
  const Route route = route_to_last({first, 0});
  WindowDefinition near;
  near.centre = PlaceId{first, 0};
  near.hops = 10;
  const Window window = make_window(server.snapshot(), near);
  robot.navigator().follow(route);
  Navigated navigated;
  for (int i = 0; i < 75; ++i) navigated = robot.step({window, server});
  EXPECT_GT(navigated.route_at, 12U);
  EXPECT_LT(test::distance_to(true_path(route), robot.world_from_robot()), 0.1);
}

TEST_F(MarksFleet, TurnsOnTheSpotWhereItWasTaughtTo) {
  // Taught by hand: straight, a quarter turn standing, straight.
  NavigatedRobot hand = robot_at({5, 5, 0}, 1);
  hand.navigator().begin_teach({first, RobotId{{1}}});
  const auto take = [&](const std::vector<Kept>& kept) {
    for (const Kept& one : kept) truth[one.place.id] = hand.world_from_robot();
    server.take(first, RobotId{{1}}, "marks", kept);
  };
  hand.hand(Course({5, 5, 0}).straight(2.0).poses, [&] { take(hand.step(server.map(), true).kept); });
  hand.spin(0.5, M_PI / 2, [&] { take(hand.step(server.map(), true).kept); });
  hand.hand(Course(hand.world_from_robot()).straight(2.0).poses, [&] { take(hand.step(server.map(), true).kept); });
  take(hand.navigator().end_teach(server.map()));

  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  const Driven driven = drive(robot, route_to_last({first, 0}));
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_LT(driven.worst_lateral_m, 0.06);
  EXPECT_LT(test::distance(robot.world_from_robot(), truth.at(last_of(first))), 0.04);
}

TEST_F(MarksFleet, AStitchThatStepsASideOrBackIsDrivenSmoothly) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  NavigatedRobot hand = localised_at({6, 5.15, 0}, {first, 5}, 2);
  hand.teach(server, second, Course({6, 5.15, 0}).straight(6.0).poses, truth);
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 3);
  const Route route = server.route({first, 0}, last_of(second), "marks");
  const Driven driven = drive(robot, route, 0.5);
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_LT(driven.worst_turn_rad_s, 0.8);
  EXPECT_LT(driven.worst_lateral_m, 0.12);
}

}  // namespace
}  // namespace weft::agents
