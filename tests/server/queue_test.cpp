#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

/// Tests goals that wait for their turn: what they cost, and what they say.
namespace weft::server::test {
namespace {

using testing::HasSubstr;

struct Queue : testing::Test {
  Queue() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(40));
    site.label("near", run.place(5));
    site.label("far", run.place(39));
    site.say(site.state(r1, run.place(0)));
  }
  /// Asks for goals while the robot is somewhere on its way.
  void ask_for(std::uint8_t goals, const std::string& robot) {
    for (std::uint8_t number = 1; number <= goals; ++number) site.send_goal(number, "far", robot);
    site.pass(2s);
  }
  /// Drives r1 to the end of its route, and puts it at the run's beginning again.
  void drive_once() {
    const Route route = site.last<msg::RouteOrder>().value().route;
    site.progress(r1, route, msg::RoutePhase::driving);
    site.pass(500ms);
    site.progress(r1, route, msg::RoutePhase::arrived, route.released);
    site.say(site.state(r1, run.place(0)));
    site.pass(2s);
    site.say(site.state(r1, run.place(0)));
    site.pass(2s);
  }
  struct Cost {
    std::uint64_t events = 0;
    std::uint64_t commits = 0;
  };
  Cost now() const { return {site.disk->events.size(), site.disk->commits}; }
  /// Returns the cost of asking for so many goals, and driving to some of them.
  Cost cost_of(std::uint8_t goals, int driven, const std::string& robot) {
    const Cost before = now();
    ask_for(goals, robot);
    for (int i = 0; i < driven; ++i) drive_once();
    const Cost after = now();
    return {after.events - before.events, after.commits - before.commits};
  }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
};

TEST_F(Queue, CostsEventsAndCommitsAsManyAsItsGoalsNotItsSquare) {
  constexpr int kDriven = 10;
  const Cost cost = cost_of(60, kDriven, "r1");
  for (std::uint8_t number = 1; number <= kDriven; ++number) {
    EXPECT_EQ(site.goal(number).state, GoalState::succeeded) << int{number};
  }
  // Each goal is asked for and says once that it waits; each one driven is assigned, released, freed, ended.
  EXPECT_LE(cost.events, 60U * 3 + kDriven * 8);
  EXPECT_LE(cost.commits, 60U * 3 + kDriven * 12);
}

TEST_F(Queue, OfGoalsForAnyRobotCostsNoMore) {
  const Cost cost = cost_of(60, 10, "");
  EXPECT_LE(cost.events, 60U * 3 + 10 * 8);
  EXPECT_LE(cost.commits, 60U * 3 + 10 * 12);
}

/// Shows that a goal for whose label there is no way is tried again after each of the others, and says so once.
TEST_F(Queue, OfGoalsWithoutAWayCostsNoMore) {
  TaughtRun island(r1, 11);
  site.hand_in(r1, island.next(3));
  site.label("island", island.place(1));
  const Cost before = now();
  for (std::uint8_t number = 101; number <= 130; ++number) site.send_goal(number, "island", "r1");
  const Cost cost = cost_of(20, 10, "r1");
  EXPECT_EQ(site.goal(10).state, GoalState::succeeded);
  EXPECT_LE(now().events - before.events, 50U * 4 + 10 * 10);
  EXPECT_LE(cost.commits, 50U * 4 + 10 * 14);
}

TEST_F(Queue, TheFirstSaysWhatItWaitsForTheOthersThatItComesFirst) {
  ask_for(4, "r1");
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
  EXPECT_THAT(site.goal(2).history.back().cause, HasSubstr("r1 has goal " + to_string(goal_id(1))));
  for (const std::uint8_t number : {std::uint8_t{3}, std::uint8_t{4}}) {
    EXPECT_THAT(site.goal(number).history.back().cause, HasSubstr("goals for r1 that were asked for earlier"));
  }
  drive_once();
  EXPECT_EQ(site.goal(2).state, GoalState::assigned);
  EXPECT_THAT(site.goal(3).history.back().cause, HasSubstr("r1 has goal " + to_string(goal_id(2))));
}

TEST_F(Queue, WhatTheStoreDidNotTakeIsSaidLater) {
  ask_for(1, "r1");
  site.send_goal(2, "far", "r1");
  site.disk->faults.full = true;
  site.pass(2s);
  EXPECT_EQ(site.goal(2).state, GoalState::pending);
  site.disk->faults.full = false;
  site.say(site.state(r1, run.place(0)));
  site.send_goal(3, "far", "r1");
  site.pass(2s);
  EXPECT_THAT(site.goal(2).history.back().cause, HasSubstr("r1 has goal"));
}

}  // namespace
}  // namespace weft::server::test
