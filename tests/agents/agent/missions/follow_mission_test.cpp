#include "agents/agent/missions/follow_mission.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Took = FollowMission::Took;

struct FollowBench : Bench {
  FollowBench() : laid(lay_out(server, 70, 20)) { script->estimate = Estimate{{laid, 0}, Relation{}, 0.0}; }
  /// Arranges the mission with a route that is followed.
  void drive() {
    fetch_map();
    EXPECT_EQ(mission.take(a_route(laid, 10, 1), false, now), Took::route);
    mission.tick(true, now);
    EXPECT_EQ(script->followed.size(), 1U);
  }
  void see(Following following, std::string_view reason = {}) {
    Navigated navigated;
    navigated.following = following;
    navigated.reason = reason;
    mission.step(navigated, false, now);
  }
  msg::RoutePhase phase() const { return mission.task().phase(); }
  ExperienceId laid;
  FollowMission mission{{*navigator, map, outbox}};
};

TEST(FollowMission, NewRouteWaitsForTheMapOfItsBeginning) {
  FollowBench bench;
  EXPECT_EQ(bench.mission.take(a_route(bench.laid, 20, 1), false, bench.now), Took::route);
  bench.mission.tick(true, bench.now);
  EXPECT_TRUE(bench.script->followed.empty());
  EXPECT_EQ(bench.mission.waits_for(), "waits for the map of its route");
  EXPECT_EQ(bench.phase(), msg::RoutePhase::waiting);
  bench.fetch_map();
  bench.mission.tick(true, bench.now);
  EXPECT_EQ(bench.script->followed.size(), 1U);
  EXPECT_EQ(bench.mission.waits_for(), "");
}

TEST(FollowMission, AfterTwentySecondsTheMapThatIsThereHasToDo) {
  FollowBench bench;
  bench.mission.take(a_route(bench.laid, 20, 1), false, bench.now);
  bench.mission.was_away(3s);
  bench.mission.tick(true, bench.now + 22s);
  EXPECT_TRUE(bench.script->followed.empty());
  bench.mission.tick(true, bench.now + 23s);
  EXPECT_EQ(bench.script->followed.size(), 1U);
}

TEST(FollowMission, RobotThatDoesNotKnowWhereItIsWaitsAsLongAsThatLasts) {
  FollowBench bench;
  bench.script->estimate.reset();
  bench.fetch_map();
  bench.mission.take(a_route(bench.laid, 20, 1), false, bench.now);
  bench.mission.tick(true, bench.now + 1h);
  EXPECT_TRUE(bench.script->followed.empty());
  EXPECT_EQ(bench.mission.waits_for(), "does not know where it is: looks for itself");
}

TEST(FollowMission, ItsDeadlineCountsOnlyWhenItMayDrive) {
  FollowBench bench;
  bench.mission.take(a_route(bench.laid, 20, 1), false, bench.now);
  std::ignore = bench.mission.due(bench.now);  // the report, whose repeat is due in 2 s
  EXPECT_EQ(bench.mission.next(true), bench.now + 2s);
  std::ignore = bench.mission.due(bench.now + 19s);
  EXPECT_EQ(bench.mission.next(true), bench.now + 20s);
  EXPECT_EQ(bench.mission.next(false), bench.now + 21s);
  bench.mission.tick(false, bench.now + 1h);
  EXPECT_TRUE(bench.script->followed.empty());
}

TEST(FollowMission, StopHoldsTheRouteUntilItMayDriveAgain) {
  FollowBench bench;
  bench.drive();
  bench.mission.stop("stopped by an operator", bench.now);
  EXPECT_EQ(bench.phase(), msg::RoutePhase::stopped);
  bench.mission.tick(false, bench.now + 1s);
  EXPECT_EQ(bench.script->followed.size(), 1U);
  bench.mission.resume(bench.now + 1s);
  bench.mission.tick(true, bench.now + 1s);
  EXPECT_EQ(bench.script->followed.size(), 2U);
}

TEST(FollowMission, ReleaseIsFollowedAtOnceButNotByAStoppedRobot) {
  FollowBench bench;
  bench.fetch_map();
  Route route = a_route(bench.laid, 10, 1);
  route.released = 2;
  bench.mission.take(route, false, bench.now);
  bench.mission.tick(true, bench.now);
  route.released = 3;
  EXPECT_EQ(bench.mission.take(route, false, bench.now), Took::nothing) << "the places are the same";
  EXPECT_EQ(bench.script->followed.back().released, 3U);
  route.released = 4;
  bench.mission.take(route, true, bench.now);
  EXPECT_EQ(bench.script->followed.back().released, 3U);
}

/// Arranges a route twice round the same ten places, released to the 14th; the robot says how far along it is.
struct RoundBench : FollowBench {
  RoundBench() : route(a_route(laid, 10, 1)) {
    const std::vector<PlaceId> round = route.places;
    route.places.insert(route.places.end(), round.begin(), round.end());
    route.relations.resize(19, route.relations.front());
    route.released = 14;
    fetch_map();
    mission.take(route, false, now);
    mission.tick(true, now);
  }
  void reach(std::uint32_t at) {
    Navigated navigated;
    navigated.following = Following::driving;
    navigated.route_at = at;
    navigated.route_freed = at - 1;
    mission.step(navigated, false, now);
  }
  Route route;
};

TEST(FollowMission, NextVersionIsFollowedFromWhereTheRobotIsOnIt) {
  RoundBench bench;
  bench.reach(12);
  bench.route.version = 2;
  bench.route.places.back() = {bench.laid, 19};
  EXPECT_EQ(bench.mission.take(bench.route, false, bench.now), Took::route);
  EXPECT_EQ(bench.script->followed_from.back(), 12U) << "the first round is driven again";
  const auto report = bench.mission.due(bench.now + 1s);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->at, 12U);
  EXPECT_EQ(report->freed, 11U);
}

TEST(FollowMission, VersionThatBeginsElsewhereIsFollowedFromItsBeginning) {
  RoundBench bench;
  bench.reach(12);
  Route next = a_route(bench.laid, 15, 1);
  next.version = 2;
  bench.mission.take(next, false, bench.now);
  EXPECT_EQ(bench.script->followed_from.back(), 0U);
}

TEST(FollowMission, RouteIsTakenUpAfterAStopWhereItWasLeft) {
  RoundBench bench;
  bench.reach(12);
  bench.mission.stop("stopped by an operator", bench.now);
  bench.mission.resume(bench.now);
  bench.mission.tick(true, bench.now);
  EXPECT_EQ(bench.script->followed_from.back(), 12U);
}

TEST(FollowMission, EndStandsAndForgetsTheRoute) {
  FollowBench bench;
  bench.drive();
  Route ended = a_route(bench.laid, 10, 1);
  ended.ended = true;
  const int stops = bench.script->stops;
  EXPECT_EQ(bench.mission.take(ended, false, bench.now), Took::end);
  EXPECT_EQ(bench.script->stops, stops + 1);
  EXPECT_FALSE(bench.mission.has_route());
}

TEST(FollowMission, AstrayRouteIsGivenBackOnceItIsKnownToBeSo) {
  FollowBench bench;
  bench.drive();
  EXPECT_FALSE(bench.mission.give_back_if_astray());
  bench.see(Following::stopped, "off_route");
  EXPECT_TRUE(bench.mission.strays());
  EXPECT_TRUE(bench.mission.give_back_if_astray());
  EXPECT_FALSE(bench.mission.has_route());
  EXPECT_EQ(bench.take().notes.size(), 1U);
  EXPECT_EQ(bench.mission.take(a_route(bench.laid, 10, 1), false, bench.now), Took::nothing)
      << "what is released of that version is not taken up again";
}

TEST(FollowMission, LostRobotStandsAndHasNotArrived) {
  FollowBench bench;
  bench.drive();
  Navigated lost;
  lost.lost = true;
  lost.following = Following::arrived;
  lost.reason = "blind";
  bench.mission.step(lost, false, bench.now);
  EXPECT_EQ(bench.phase(), msg::RoutePhase::stopped);
  EXPECT_TRUE(bench.mission.is_under_way());
}

TEST(FollowMission, ArrivalSaysWhereItStandsBesideTheGoal) {
  FollowBench bench;
  bench.drive();
  bench.script->estimate = Estimate{{bench.laid, 8}, Relation{}, 0.0};
  bench.see(Following::arrived);
  EXPECT_FALSE(bench.mission.is_under_way());
  const std::optional<msg::RouteProgress> report = bench.mission.due(bench.now + 1s);
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->phase, msg::RoutePhase::arrived);
  EXPECT_NEAR(distance_m(report->goal_from_robot), 1.0, 1e-9) << "one place before the goal";
}

TEST(FollowMission, SearchForWhereItIsHoldsARouteThatIsUnderWay) {
  FollowBench bench;
  bench.mission.await_localisation(bench.now);
  EXPECT_FALSE(bench.mission.next(true).has_value()) << "without a route there is nothing to hold";
  bench.drive();
  bench.mission.await_localisation(bench.now);
  bench.see(Following::driving);
  EXPECT_NE(bench.phase(), msg::RoutePhase::driving);
  bench.mission.tick(true, bench.now);
  EXPECT_EQ(bench.script->followed.size(), 2U);
}

}  // namespace
}  // namespace weft::agents::test
