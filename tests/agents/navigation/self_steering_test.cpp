// Methods that find their own way among the released places.
#include "agents/navigation/follower.hpp"
#include "agents/navigation/released_places.hpp"
#include "agents/navigation/ways.hpp"
#include "tests/agents/navigation/roamer_fleet.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

using test::Course;
using test::NavigatedRobot;

constexpr ExperienceId kSteered{4};

/// Returns a route along x through these points, facing ahead at each, released to its end.
Route route_through(const std::vector<double>& x_m) {
  Route route;
  for (std::uint32_t i = 0; i < x_m.size(); ++i) {
    route.places.push_back({kSteered, i});
    if (i > 0) route.relations.emplace_back(Metric2{{x_m[i] - x_m[i - 1], 0.0, 0.0}});
  }
  route.released = static_cast<std::uint32_t>(x_m.size() - 1);
  return route;
}

/// Arranges a robot at the first place of a route, whose method finds its way.
struct ByPlaces : testing::Test {
  Follower::Drive look(double x_m, double speed_m_s = 0.0) {
    const std::optional<Estimate> estimate = Estimate{{kSteered, 0}, Metric2{{x_m, 0.0, 0.0}}, 0.0};
    return follower.look({window, estimate, false, speed_m_s, 1s});
  }
  Navigated steer(const Steering& steering) {
    Follower::Drive drive = look(0.0);
    EXPECT_TRUE(drive.along);
    follower.steered(steering, 1s, drive.navigated);
    return drive.navigated;
  }

  NavigationConfig config;
  Window window = [] {
    Window one;
    one.places.emplace(PlaceId{kSteered, 0}, Place{});
    index_edges(one);
    return one;
  }();
  Follower follower{config, Manner{.by_places = true}};
};

TEST_F(ByPlaces, GetsThePlacesAsTheyLieWithoutAPathThroughThem) {
  follower.follow(route_through({0.0, 0.5, 0.4, 0.9}));
  const Follower::Drive drive = look(0.1);
  ASSERT_TRUE(drive.along);
  EXPECT_FALSE(drive.path);
  ASSERT_EQ(drive.along->robot_from_path.size(), 4U) << "the one that steps back, too";
  EXPECT_NEAR(drive.along->robot_from_path[2].x, 0.3, 1e-9);
  EXPECT_NEAR(drive.along->to_end_m, 0.4 + 0.1 + 0.5, 1e-9);
  EXPECT_TRUE(drive.along->end_is_goal);
  EXPECT_EQ(drive.along->aside_m, config.follow.aside_m);
}

TEST_F(ByPlaces, IsOnItsRouteWhereverItMaySteerTo) {
  config.follow.aside_m = 2.5;
  follower = Follower(config, Manner{.by_places = true});
  follower.follow(route_through({0.0, 0.5, 1.0}));
  const auto reason_at = [&](double aside_m) {
    const std::optional<Estimate> estimate = Estimate{{kSteered, 0}, Metric2{{0.5, aside_m, 0.0}}, 0.0};
    return follower.look({window, estimate, false, 0.0, 1s}).navigated.reason;
  };
  EXPECT_EQ(reason_at(config.follow.aside_m + 0.1), "");
  EXPECT_EQ(reason_at(config.follow.aside_m + 0.3), "off_route");
  config.follow.aside_m = 0.0;
  follower = Follower(config, Manner{.by_places = true});
  follower.follow(route_through({0.0, 0.5, 1.0}));
  EXPECT_EQ(reason_at(0.5 * longest_shortcut_m), "") << "half way along a shortcut it gets a route from its end";
}

TEST_F(ByPlaces, AWayThatLeadsBackIsNoReasonToStand) {
  follower.follow(route_through({0.0, -0.5, -1.0}));
  for (int i = 0; i < 60; ++i) EXPECT_EQ(look(0.0).navigated.following, Following::driving);
}

TEST_F(ByPlaces, WhereItStandsNearTheReleasedEndItWaits) {
  Route route = route_through({0.0, 0.5, 1.0, 1.5});
  route.released = 2;
  follower.follow(route);
  EXPECT_EQ(look(0.9, 0.3).navigated.following, Following::driving) << "it still rolls";
  EXPECT_EQ(look(0.9).navigated.reason, "waits_for_release");
  route.released = 3;
  follower.follow(route);
  EXPECT_EQ(look(0.9).navigated.following, Following::driving);
}

TEST_F(ByPlaces, AStopIsGivenUpAfterAWhile) {
  follower.follow(route_through({0.0, 0.5, 1.0}));
  const Steering blocked = tl::unexpected(Stop{"blocked"});
  Navigated navigated;
  for (double stood_s = 0.0; stood_s < config.follow.give_up_s; ++stood_s) {
    navigated = steer(blocked);
    EXPECT_EQ(navigated.following, Following::stopped);
    EXPECT_EQ(navigated.reason, "blocked");
    EXPECT_EQ(navigated.command, Twist{});
  }
  navigated = steer(blocked);
  EXPECT_EQ(navigated.following, Following::failed);
  EXPECT_EQ(navigated.reason, "blocked");
}

TEST_F(ByPlaces, ASampleThatDrivesEndsTheCountAndOneThatStandsDoesNot) {
  follower.follow(route_through({0.0, 0.5, 1.0}));
  const Steering blocked = tl::unexpected(Stop{"blocked"});
  const auto stand = [&](double for_s, const Steering& between) {
    for (double stood_s = 0.0; stood_s + 1.0 < for_s; ++stood_s) steer(blocked);
    return steer(between);
  };
  EXPECT_EQ(stand(config.follow.give_up_s - 1.0, Twist{0.1, 0.0}).command.linear_m_s, 0.1);
  EXPECT_EQ(stand(config.follow.give_up_s - 1.0, Twist{}).following, Following::driving);
  steer(blocked);
  steer(blocked);
  EXPECT_EQ(steer(blocked).following, Following::failed);
}

TEST(AwayFromWay, HalfWayAlongALongHopTheRobotIsOnIt) {
  RouteAround around;
  around.poses = {{0, {-1.9, 0.1, 0.0}}, {1, {2.0, 0.1, 0.0}}};
  for (const std::size_t nearest : {0U, 1U}) {
    around.nearest = nearest;
    EXPECT_NEAR(away_from_way_m(around), 0.1, 1e-9);
  }
  around.poses = {{0, {0.3, 0.4, 0.0}}, {1, {2.0, 0.4, 0.0}}};
  around.nearest = 0;
  EXPECT_NEAR(away_from_way_m(around), 0.5, 1e-9) << "before the first place";
}

TEST(WayLeft, IsMeasuredFromTheNearestPointOn) {
  EXPECT_DOUBLE_EQ(way_left_m({{-0.5, 0.1, 0.0}, {0.5, 0.1, 0.0}, {0.5, 1.1, 0.0}}), 1.5);
  EXPECT_DOUBLE_EQ(way_left_m({{-1.0, 0.0, 0.0}, {-0.5, 0.0, 0.0}}), 0.0) << "the end lies behind";
  EXPECT_DOUBLE_EQ(way_left_m({{0.2, 0.0, 0.0}}), 0.0);
}

class Roaming : public RoamerFleet {
 protected:
  void SetUp() override {
    navigation.teach.spacing_m = 0.5;
    navigation.teach.spacing_rad = 0.35;
    teach(first, Course({5, 5, 0}).straight(9.0).turn(1.0, M_PI / 2).straight(6.0).poses);
  }
};

TEST_F(Roaming, IsToldWhereItIsInItsChartFromItsFirstStepToTheGoal) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  const Route route = route_to_last({first, 0});
  double worst_m = 0.0;
  const Driven driven = drive(robot, route, 1.0, [&](const Navigated& navigated) {
    if (navigated.following == Following::driving && noted->ahead && !noted->ahead->end_is_goal)
      worst_m = std::max(worst_m, believed_error_m(robot));
  });
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_LT(test::distance(robot.world_from_robot(), truth.at(route.places.back())), 0.07);
  EXPECT_LT(test::turned(robot.world_from_robot(), truth.at(route.places.back())), 0.07);
  EXPECT_GT(noted->steered_in_chart, 100);
  EXPECT_EQ(noted->steered_without_chart, 0);
  EXPECT_LT(worst_m, 0.1);
}

TEST_F(Roaming, ItsBeliefGoesOnFromChartToChart) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  const int begun = noted->begun;
  noted->carried = 0;
  drive(robot, route_to_last({first, 0}));
  EXPECT_GE(noted->carried, 2) << "15 m, and the middle of a chart is 3 m on";
  EXPECT_LE(noted->begun, begun + 1) << "where it was found, and never again";
}

TEST_F(Roaming, BlockedItGivesItsRouteUp) {
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  robot.navigator().follow(route_to_last({first, 0}));
  run(robot, 30);
  noted->stops_for = "blocked";
  Navigated navigated = run(robot, 5);
  EXPECT_EQ(navigated.following, Following::stopped);
  EXPECT_EQ(navigated.reason, "blocked");
  EXPECT_EQ(navigated.command, Twist{});
  for (int i = 0; i < 400 && navigated.following == Following::stopped; ++i) navigated = run(robot, 1);
  EXPECT_EQ(navigated.following, Following::failed);
  EXPECT_EQ(navigated.reason, "blocked");
}

}  // namespace
}  // namespace weft::agents
