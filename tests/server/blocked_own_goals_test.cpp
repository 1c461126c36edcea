#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/blocked_on_run.hpp"

/// Tests that what the server asks of a robot by itself leads round what that robot has found in its way.
namespace weft::server::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

struct BlockedOwnGoals : BlockedOnRun {
  void put(RuleKind kind) {
    ASSERT_EQ(site.put_rule({.name = "spot", .kind = kind, .label = "dock"}).outcome, msg::Outcome::done);
  }
  /// Has r1 sent to park at the end of the run, from its beginning.
  Route start_to_park() {
    put(RuleKind::parking);
    site.stand(r1, run.place(1), 12);
    EXPECT_THAT(parkings(), SizeIs(1));
    return *site.order_to(r1);
  }
  std::vector<Goal> parkings() { return site.goals_of(GoalKind::park); }
};

TEST_F(BlockedOwnGoals, WhoParksIsSentAnewRoundWhatItFound) {
  const Route route = start_to_park();
  ASSERT_THAT(route.places, Contains(run.place(12)));
  give_up(route, 9);
  const Goal first = parkings().front();
  EXPECT_EQ(first.state, GoalState::failed);
  EXPECT_THAT(first.history.back().cause, HasSubstr("closed for what it is asked for by the server until"));
  obey(run.place(10), 15);
  ASSERT_THAT(parkings(), SizeIs(2));
  const Route round = *site.order_to(r1);
  EXPECT_NE(round.goal, route.goal);
  EXPECT_THAT(round.places, AllOf(Contains(bypass.place(2)), Not(Contains(run.place(12)))));
  EXPECT_EQ(round.released + 1, round.places.size()) << "the plan leads it round, too";
}

TEST_F(BlockedOwnGoals, WhoDoesNotMoveOnItsWayToASpotGivesThatUpToo) {
  const Route route = start_to_park();
  stand_blocked(route, 9, 29s);
  EXPECT_FALSE(site.order().ended);
  stand_blocked(route, 9, 3s);
  EXPECT_EQ(parkings().front().state, GoalState::failed);
  EXPECT_TRUE(site.order().ended);
}

TEST_F(BlockedOwnGoals, WithNoOtherWayItStaysAndIsSentAgainTenMinutesLater) {
  give_up(start_to_park(), 24);
  obey(run.place(25), 590);
  EXPECT_THAT(parkings(), SizeIs(1));
  site.stand(r1, run.place(25), 30);
  EXPECT_THAT(parkings(), SizeIs(2));
}

TEST_F(BlockedOwnGoals, WhoChargesGoesRoundOrSaysThatItCannot) {
  put(RuleKind::charging);
  site.power(r1, 0.08);
  site.stand(r1, run.place(1), 3);
  ASSERT_THAT(site.goals_of(GoalKind::charge), SizeIs(1));
  give_up(*site.order_to(r1), 9);
  obey(run.place(10), 3);
  ASSERT_THAT(site.goals_of(GoalKind::charge), SizeIs(2));
  const Route round = *site.order_to(r1);
  EXPECT_THAT(round.places, Contains(bypass.place(2)));
  const auto at = static_cast<std::uint32_t>(std::ranges::find(round.places, run.place(25)) - round.places.begin());
  give_up(round, at);
  obey(run.place(25), 30);
  EXPECT_THAT(site.goals_of(GoalKind::charge), SizeIs(2)) << "it does not try the same again and again";
  EXPECT_THAT(site.events_of("robot.no_way_to_charger"), SizeIs(1));
}

/// Arranges r1 idle at place 10, where the bypass leaves, and r2 that is to drive by there.
struct MakesWay : BlockedOwnGoals {
  /// Returns where r1 is sent to make way.
  std::vector<PlaceId> places_of_way() {
    site.arrive(r2, run.place(0));
    site.hush();
    site.send_goal(2, "dock", "r2");
    for (int second = 0; second < 4; ++second) {
      site.say(site.state(r2, run.place(0)));
      site.stand(r1, run.place(10), 1);
    }
    EXPECT_THAT(site.goals_of(GoalKind::yield), SizeIs(1));
    return site.order_to(r1)->places;
  }
  Peer r2{.id = robot_id(2), .name = "r2"};
};

TEST_F(MakesWay, IntoTheBypassWhereNothingWasFound) {
  site.stand(r1, run.place(10), 1);
  EXPECT_THAT(places_of_way(), Contains(bypass.place(0)));
}

TEST_F(MakesWay, ElsewhereWhereAnOperatorsGoalFoundThatBlocked) {
  site.label("bay", bypass.place(3));
  site.say(site.state(r1, run.place(5)));
  site.send_goal(1, "bay", "r1");
  site.pass(1s);
  give_up(*site.order_to(r1), 5);
  msg::OperatorRequest cancel = site.request(msg::OperatorRequest::Kind::goal_cancel);
  cancel.goal = goal_id(1);
  site.ask(cancel);
  site.stand(r1, run.place(10), 3);
  EXPECT_THAT(places_of_way(), AllOf(Contains(run.place(12)), Not(Contains(bypass.place(0)))));
}

}  // namespace
}  // namespace weft::server::test
