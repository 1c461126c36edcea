#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/one_run.hpp"

/// Tests how robots' charge decides which robot takes a goal, and when one is sent to a charger.
namespace weft::server::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Arranges a shelf on the run, and a charger near its end.
struct Charging : OneRun {
  Charging() {
    site.label("shelf", run.place(20));
    site.label("plug", run.place(50));
    site.say(site.state(r1, run.place(0)));
  }
  void put_charger() {
    const Rule rule{.name = "plug", .kind = RuleKind::charging, .label = "plug"};
    ASSERT_EQ(site.put_rule(rule).outcome, msg::Outcome::done);
  }
  /// Starts the server anew; it is told that a full battery drives 100 m.
  void restart_with_small_batteries() {
    site.charge.range_m = 100.0;
    site.restart();
  }
  std::vector<Goal> charges() { return site.goals_of(GoalKind::charge); }
  /// Has the robot drive to the end of what it was given, and stand there.
  void arrive_at_the_end_of(Peer& robot, const Route& route) {
    site.progress(robot, route, msg::RoutePhase::arrived, route.released);
    site.stand(robot, route.places[route.released], 3);
  }
};

TEST_F(Charging, WhoIsCriticalChargesBeforeItsNextGoal) {
  put_charger();
  site.power(r1, 0.08);
  site.send_goal(1, "shelf", "r1");
  site.stand(r1, run.place(0), 3);
  ASSERT_THAT(charges(), SizeIs(1));
  const Goal charge = charges().front();
  EXPECT_EQ(charge.to, run.place(50));
  EXPECT_EQ(charge.robot, r1.id);
  EXPECT_EQ(charge.history.front().who, "traffic");
  EXPECT_THAT(charge.history.front().cause, HasSubstr("r1 has 8 %: it goes to a charger"));
  EXPECT_EQ(site.order_to(r1)->goal, charge.id);
  EXPECT_EQ(site.goal(1).state, GoalState::pending);
}

TEST_F(Charging, WhoChargesTakesItsGoalOnceItHasEnough) {
  put_charger();
  site.power(r1, 0.08);
  site.label("end", run.place(58));
  site.send_goal(1, "end", "r1");
  site.stand(r1, run.place(0), 3);
  arrive_at_the_end_of(r1, site.order_to(r1).value());
  EXPECT_EQ(charges().front().state, GoalState::succeeded);
  site.power(r1, 0.5, true);
  site.stand(r1, run.place(50), 3);
  EXPECT_EQ(site.goal(1).state, GoalState::pending);
  EXPECT_EQ(site.why(1), "r1 is to charge, and takes goals from 60 % on");
  EXPECT_THAT(charges(), SizeIs(1)) << "it stands at a charger";
  site.power(r1, 0.61, true);
  site.stand(r1, run.place(50), 3);
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
}

TEST_F(Charging, WhoIsLowTakesAGoalFirstAndChargesWhenItIsIdle) {
  put_charger();
  site.power(r1, 0.2);
  site.send_goal(1, "shelf");
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
  EXPECT_THAT(charges(), IsEmpty());
  arrive_at_the_end_of(r1, site.order_to(r1).value());
  ASSERT_THAT(charges(), SizeIs(1));
  EXPECT_EQ(site.order_to(r1)->places.back(), run.place(50));
}

TEST_F(Charging, AGoalIsGivenOnlyToWhoseChargeCoversItAndTheWayToACharger) {
  restart_with_small_batteries();
  site.arrive(r1, run.place(0));
  put_charger();
  // 10 m to the shelf and 15 m on to the charger: 25 %, and 5 % are kept.
  site.power(r1, 0.29);
  site.send_goal(1, "shelf");
  site.stand(r1, run.place(0), 3);
  EXPECT_EQ(site.goal(1).state, GoalState::pending);
  EXPECT_THAT(site.events_of("goal.waits"),
              Contains(HasSubstr("10 m to there and 15 m on to a charger: that needs 30 %")));
  ASSERT_THAT(charges(), SizeIs(1)) << "it is not low, but of no use like this";
}

TEST_F(Charging, AGoalThatTheChargeCoversIsGiven) {
  restart_with_small_batteries();
  site.arrive(r1, run.place(0));
  put_charger();
  site.power(r1, 0.31);
  site.send_goal(1, "shelf");
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
}

TEST_F(Charging, TheNextOneTakesAGoalThatTheNearestOnesChargeDoesNotCover) {
  restart_with_small_batteries();
  site.arrive(r1, run.place(5));
  site.arrive(r2, run.place(0));
  put_charger();
  site.power(r1, 0.27);
  site.power(r2, 0.5);
  site.send_goal(1, "shelf");
  EXPECT_EQ(site.goal(1).robot, r2.id);
}

TEST_F(Charging, WithoutAChargerOnTheMapNothingIsDecidedByIt) {
  site.power(r1, 0.02);
  site.send_goal(1, "shelf");
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
}

TEST_F(Charging, AnUnknownChargeIsSaidOnceAndDecidesNothing) {
  put_charger();
  for (int report = 0; report < 10; ++report) site.stand(r1, run.place(0), 3);
  EXPECT_THAT(site.events_of("robot.charge_unknown"), SizeIs(1));
  site.send_goal(1, "shelf");
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
  EXPECT_THAT(charges(), IsEmpty());
}

TEST_F(Charging, WhoFindsAllChargersTakenWaitsForItsTurn) {
  put_charger();
  site.say(site.state(r1, run.place(10)));
  site.arrive(r2, run.place(0));
  site.power(r1, 0.2);
  site.stand(r1, run.place(10), 3);
  ASSERT_THAT(charges(), SizeIs(1));
  site.power(r2, 0.15);
  site.stand(r2, run.place(0), 3);
  EXPECT_THAT(charges(), SizeIs(1));
  EXPECT_THAT(site.events_of("robot.waits_for_charger"), ElementsAre("r2 has 15 %: all chargers are taken"));
}

TEST_F(Charging, WhoIsFullMakesWayAtTheCharger) {
  put_charger();
  site.arrive(r2, run.place(50));
  site.power(r2, 0.9, true);
  site.power(r1, 0.2);
  site.stand(r1, run.place(0), 3);
  EXPECT_THAT(charges(), IsEmpty()) << "r2 charges still";
  site.power(r2, 0.95, true);
  site.stand(r1, run.place(0), 3);
  ASSERT_THAT(charges(), SizeIs(1));
  EXPECT_EQ(charges().front().robot, r1.id);
}

TEST_F(Charging, GoesOnAfterARestartOfTheServer) {
  put_charger();
  site.power(r1, 0.08);
  site.stand(r1, run.place(0), 3);
  const Route order = site.order_to(r1).value();
  site.restart();
  site.arrive(r1, run.place(0));
  site.power(r1, 0.08);
  site.pass(2s);
  EXPECT_EQ(site.order_to(r1)->id, order.id);
  arrive_at_the_end_of(r1, site.order_to(r1).value());
  EXPECT_EQ(charges().front().state, GoalState::succeeded);
}

TEST_F(Charging, ARestartedRobotThatHasLostItsWayThereIsAskedAgain) {
  put_charger();
  site.power(r1, 0.08);
  site.stand(r1, run.place(0), 3);
  r1.incarnation = 2;
  site.arrive(r1, run.place(0));
  site.power(r1, 0.08);
  site.stand(r1, run.place(0), 3);
  site.stand(r1, run.place(0), 3);
  ASSERT_THAT(charges(), SizeIs(2));
  int cancelled = 0;
  for (const Goal& goal : charges()) cancelled += goal.state == GoalState::cancelled ? 1 : 0;
  EXPECT_EQ(cancelled, 1);
}

}  // namespace
}  // namespace weft::server::test
