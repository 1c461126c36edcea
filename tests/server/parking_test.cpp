#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/one_run.hpp"

/// Tests that idle robots that stand in the way go to parking places.
namespace weft::server::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Arranges a run at whose end robots can park.
struct Parking : OneRun {
  Parking() {
    site.label("shelf", run.place(30));
    site.label("bay", run.place(58));
    site.say(site.state(r1, run.place(20)));
  }
  void put(const std::string& name, RuleKind kind) {
    ASSERT_EQ(site.put_rule({.name = name, .kind = kind, .label = name}).outcome, msg::Outcome::done);
  }
  std::vector<Goal> parkings() { return site.goals_of(GoalKind::park); }
};

TEST_F(Parking, WhoStandsOnALaneParksAfterTenSeconds) {
  put("bay", RuleKind::parking);
  site.stand(r1, run.place(20), 9);
  EXPECT_THAT(parkings(), IsEmpty());
  site.stand(r1, run.place(20), 3);
  ASSERT_THAT(parkings(), SizeIs(1));
  const Goal parking = parkings().front();
  EXPECT_EQ(parking.to, run.place(58));
  EXPECT_EQ(parking.history.front().who, "traffic");
  EXPECT_THAT(parking.history.front().cause, HasSubstr("r1 parks"));
  const Route route = site.order();
  EXPECT_EQ(route.goal, parking.id);
  site.progress(r1, route, msg::RoutePhase::arrived, route.released);
  site.stand(r1, run.place(58), 30);
  ASSERT_THAT(parkings(), SizeIs(1)) << "it stays there";
  EXPECT_EQ(parkings().front().state, GoalState::succeeded);
}

TEST_F(Parking, WithoutAParkingPlaceItStays) {
  site.stand(r1, run.place(20), 30);
  EXPECT_THAT(parkings(), IsEmpty());
}

TEST_F(Parking, WhereOnlyATakenOneCanBeReachedItStays) {
  put("bay", RuleKind::parking);
  site.arrive(r2, run.place(58));
  site.stand(r1, run.place(20), 30);
  EXPECT_THAT(parkings(), IsEmpty());
}

TEST_F(Parking, TwoDoNotGoToOnePlace) {
  put("bay", RuleKind::parking);
  site.arrive(r2, run.place(40));
  for (int second = 0; second < 15; ++second) {
    site.say(site.state(r2, run.place(40)));
    site.stand(r1, run.place(20), 1);
  }
  EXPECT_THAT(parkings(), SizeIs(1));
}

TEST_F(Parking, WhoStandsWhereNobodyComesByStays) {
  put("bay", RuleKind::parking);
  site.stand(r1, run.place(59), 30);
  EXPECT_THAT(parkings(), IsEmpty());
}

TEST_F(Parking, WhoIsHeldOrTaughtIsLeftAlone) {
  put("bay", RuleKind::parking);
  msg::OperatorRequest hold = site.request(msg::OperatorRequest::Kind::hold);
  hold.robot = "r1";
  site.ask(hold);
  site.stand(r1, run.place(20), 15);
  EXPECT_THAT(parkings(), IsEmpty());
}

TEST_F(Parking, WhoHasJustComeToItsGoalIsAtWorkThere) {
  put("bay", RuleKind::parking);
  site.send_goal(1, "shelf", "r1");
  const Route route = site.order();
  site.progress(r1, route, msg::RoutePhase::arrived, route.released);
  site.stand(r1, run.place(30), 9);
  EXPECT_THAT(parkings(), IsEmpty());
  site.stand(r1, run.place(30), 4);
  EXPECT_THAT(parkings(), SizeIs(1));
}

TEST_F(Parking, AGoalOfAnOperatorComesBeforeParking) {
  put("bay", RuleKind::parking);
  site.stand(r1, run.place(20), 12);
  ASSERT_THAT(parkings(), SizeIs(1));
  const Route parking = site.order();
  site.progress(r1, parking, msg::RoutePhase::driving, 0);
  site.send_goal(1, "shelf");
  msg::RobotState driving = site.state(r1, run.place(21));
  driving.mode = msg::RobotMode::driving;
  driving.route = parking.id;
  site.say(driving);
  site.pass(1s);
  EXPECT_EQ(parkings().front().state, GoalState::cancelled);
  site.stand(r1, run.place(22), 5);
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
  EXPECT_EQ(site.goal(1).robot, r1.id);
}

TEST_F(Parking, WhoChargesStaysUntilItIsFullAndAnotherOneComes) {
  site.label("plug", run.place(20));
  put("bay", RuleKind::parking);
  put("plug", RuleKind::charging);
  site.power(r1, 0.8, true);
  site.stand(r1, run.place(20), 15);
  site.power(r1, 0.97, true);
  site.stand(r1, run.place(20), 15);
  EXPECT_THAT(parkings(), IsEmpty()) << "nobody comes";
  site.arrive(r2, run.place(0));
  site.power(r2, 0.2);
  for (int second = 0; second < 15; ++second) {
    site.say(site.state(r2, run.place(0)));
    site.stand(r1, run.place(20), 1);
  }
  bool makes_way = false;
  for (const Goal& goal : site.service().goals()) {
    const bool is_own = goal.kind == GoalKind::park || goal.kind == GoalKind::yield;
    makes_way = makes_way || (is_own && goal.robot == r1.id);
  }
  EXPECT_TRUE(makes_way);
}

}  // namespace
}  // namespace weft::server::test
