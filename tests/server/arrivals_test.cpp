#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

/// Tests when robots come to their goals, as the server tells it.
namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::DoubleNear;
using testing::IsEmpty;
using testing::SizeIs;

/// Arranges a road of twenty metres with a dock at its end, and a robot at its beginning.
struct ArrivalsAtADock : testing::Test {
  ArrivalsAtADock() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, road.next(41));
    site.label("dock", road.place(40));
    site.say(site.state(r1, road.place(0)));
  }
  std::vector<msg::Arrival> arrivals() {
    msg::Query query;
    query.header = site.client.header();
    query.request = ++asked;
    query.kind = msg::Query::Kind::goals;
    site.hush();
    site.say(query);
    return site.last<msg::QueryReply>()->arrivals;
  }
  void send(std::uint8_t number) {
    site.hush();
    site.send_goal(number, "dock");
    site.pass(1s);
    take_order();
  }
  void take_order() {
    for (const msg::RouteOrder& order : site.heard<msg::RouteOrder>()) {
      if (!order.route.ended) route = order.route;
    }
  }
  void say(std::uint32_t at, msg::RoutePhase phase) {
    site.progress(r1, route, phase, at, at);
    site.say(site.driving(r1, route, route.places[at]));
    take_order();
  }
  /// Drives at a quarter of a metre a second.
  void drive(std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t at = from; at < to; ++at) {
      say(at, msg::RoutePhase::driving);
      site.pass(2s);
    }
  }
  void arrive() {
    drive(0, 40);
    say(40, msg::RoutePhase::arrived);
    ASSERT_EQ(site.goal(1).state, GoalState::succeeded) << site.goal(1).history.back().cause;
  }
  /// Reports the robot as somebody carries it back to the beginning.
  void carry_back() {
    for (const std::uint32_t at : {40U, 40U, 0U, 0U}) {
      site.say(site.state(r1, road.place(at)));
      site.pass(2s);
    }
  }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun road{r1, 10};
  Route route;
  std::uint64_t asked = 0;
};

TEST_F(ArrivalsAtADock, AreToldOfAGoalThatARobotHas) {
  EXPECT_THAT(arrivals(), IsEmpty());
  send(1);
  ASSERT_THAT(arrivals(), SizeIs(1));
  const msg::Arrival before = arrivals().front();
  EXPECT_EQ(before.goal, goal_id(1));
  EXPECT_THAT(before.in_s, DoubleNear(40.0, 0.1)) << "20 m at what is taken before anything was learned";
  EXPECT_THAT(before.soonest_s, DoubleNear(20.0, 0.1));
  EXPECT_THAT(before.latest_s, DoubleNear(80.0, 0.1));
  drive(0, 21);
  ASSERT_THAT(arrivals(), SizeIs(1));
  EXPECT_THAT(arrivals().front().in_s, DoubleNear(40.0, 0.5)) << "10 m as the first ten were driven";
  drive(21, 40);
  say(40, msg::RoutePhase::arrived);
  EXPECT_EQ(site.goal(1).state, GoalState::succeeded);
  EXPECT_THAT(arrivals(), IsEmpty());
}

TEST_F(ArrivalsAtADock, AreToldByWhatWasLearnedBeforeARestart) {
  send(1);
  arrive();
  EXPECT_THAT(site.disk->passes, SizeIs(3));
  site.restart();
  site.arrive(r1, road.place(40));
  carry_back();
  send(2);
  ASSERT_EQ(site.goal(2).robot, r1.id) << site.goal(2).history.back().cause;
  ASSERT_THAT(arrivals(), SizeIs(1));
  EXPECT_THAT(arrivals().front().in_s, DoubleNear(80.0, 0.5));
}

TEST_F(ArrivalsAtADock, AreNotToldOfWhoDoesNotMove) {
  send(1);
  drive(0, 5);
  msg::OperatorRequest stop = site.request(Kind::stop);
  stop.robot = "r1";
  site.say(stop);
  EXPECT_EQ(site.goal(1).state, GoalState::paused);
  EXPECT_THAT(arrivals(), IsEmpty());
}

TEST_F(ArrivalsAtADock, CostNoCommitOfTheirOwn) {
  send(1);
  drive(0, 40);
  EXPECT_THAT(site.disk->passes, IsEmpty());
  const std::uint64_t before = site.disk->commits;
  say(40, msg::RoutePhase::arrived);
  EXPECT_EQ(site.disk->commits, before + 1) << "that which ends the goal";
  EXPECT_THAT(site.disk->passes, SizeIs(3));
}

}  // namespace
}  // namespace weft::server::test
