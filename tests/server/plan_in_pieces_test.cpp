#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/server/arranged_site.hpp"

/// Holds that messages are heard while a plan is made, and what comes of what they say.
namespace weft::server::test {
namespace {

using testing::IsEmpty;

/// Arranges robots on a run of 600 places, half a metre apart: to look that up is more than one piece.
struct PlanInPieces : testing::Test {
  PlanInPieces() {
    for (std::uint8_t number = 1; number <= 12; ++number) {
      robots.push_back({.id = robot_id(number), .name = "r" + std::to_string(number)});
      site.arrive(robots.back(), std::nullopt);
    }
    for (int batch = 0; batch < 6; ++batch) site.hand_in(robots.front(), run.next(100));
    site.label("end", run.place(590));
    site.label("middle", run.place(300));
    stand(20);
  }
  /// Has all say where they stand, each second for so many.
  void stand(int seconds) {
    for (int second = 0; second < seconds; ++second) {
      for (std::size_t i = 0; i < robots.size(); ++i) site.say(site.state(robots[i], at(i)));
      site.pass(1s);
    }
  }
  PlaceId at(std::size_t robot) const { return run.place(static_cast<std::uint32_t>(5 + 20 * robot)); }
  /// Returns whether the server has more to do at this moment.
  bool is_busy() { return site.service().next_tick() <= site.now.steady + 1ms; }
  /// Returns how many ticks pass until the robot is told where to drive, at most so many.
  int ticks_until_ordered(const Peer& robot, int most) {
    int ticks = 0;
    for (; ticks < most && !site.order_to(robot); ++ticks) site.pass(1ms);
    return ticks;
  }
  Peer& last() { return robots.back(); }

  Site site;
  std::vector<Peer> robots;
  TaughtRun run{Peer{.id = robot_id(1), .name = "r1"}, 10};
};

TEST_F(PlanInPieces, MessagesAreHeardBeforeThePlanIsMade) {
  site.send_goal(1, "end", last().name);
  ASSERT_EQ(site.goal(1).state, GoalState::assigned);
  EXPECT_FALSE(site.order_to(last()));
  EXPECT_TRUE(is_busy());
  EXPECT_EQ(site.row(last().name).is_heard, true);
  EXPECT_LT(ticks_until_ordered(last(), 1000), 1000);
}

TEST_F(PlanInPieces, ItIsMadeThoughEveryMessageAsksForAnotherOne) {
  site.send_goal(1, "end", last().name);
  std::uint8_t number = 2;
  for (int moment = 0; moment < 200 && !site.order_to(last()); ++moment) {
    site.send_goal(number, "middle", "r3");
    site.ask([&] {
      msg::OperatorRequest request = site.request(msg::OperatorRequest::Kind::goal_cancel);
      request.goal = goal_id(number);
      return request;
    }());
    ++number;
    site.pass(1ms);
  }
  EXPECT_TRUE(site.order_to(last()));
}

TEST_F(PlanInPieces, WhoseGoalIsCancelledMeanwhileIsNotLedThere) {
  site.send_goal(1, "end", last().name);
  ASSERT_FALSE(site.order_to(last()));
  msg::OperatorRequest cancel = site.request(msg::OperatorRequest::Kind::goal_cancel);
  cancel.goal = goal_id(1);
  site.ask(cancel);
  site.pass(3s);
  EXPECT_FALSE(site.order_to(last()));
  EXPECT_THAT(site.goals_of(GoalKind::yield), IsEmpty());
}

TEST_F(PlanInPieces, WhoIsGivenAnotherGoalMeanwhileIsLedToThatOne) {
  site.send_goal(1, "end", robots.front().name);
  msg::OperatorRequest cancel = site.request(msg::OperatorRequest::Kind::goal_cancel);
  cancel.goal = goal_id(1);
  site.ask(cancel);
  site.say(site.state(robots.front(), at(0)));
  site.send_goal(2, "middle", robots.front().name);
  site.pass(3s);
  const std::optional<Route> order = site.order_to(robots.front());
  ASSERT_TRUE(order);
  EXPECT_EQ(order->goal, goal_id(2));
  EXPECT_EQ(order->places.back(), run.place(300));
}

}  // namespace
}  // namespace weft::server::test
