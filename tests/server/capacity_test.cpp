#include "server/dispatcher/capacity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::HasSubstr;

/// One run of 60 places, half a metre apart, of which two robots at most may hold 20 to 40.
struct Capacity : testing::Test {
  Capacity() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(60));
    site.label("end", run.place(55));
    site.say(site.state(r1, run.place(0)));
    put(1);
    site.hush();
  }
  void put(int most) {
    msg::OperatorRequest request = site.request(msg::OperatorRequest::Kind::rule_put);
    request.rule = {.name = "room",
                    .kind = RuleKind::capacity,
                    .value = static_cast<double>(most),
                    .spans = {{run.place(20), run.place(40)}}};
    ASSERT_EQ(site.ask(request).outcome, msg::Outcome::done);
  }
  /// Says that an operator has stopped the robot there: it makes no way.
  void stand(Peer& robot, const PlaceId& place) {
    msg::RobotState state = site.state(robot, place);
    state.mode = msg::RobotMode::stopped;
    site.say(state);
  }
  RuleMap rules() { return RuleMap(site.service().snapshot()); }
  /// Returns the route along the run from one place to another.
  Route along(std::uint32_t from, std::uint32_t to) {
    Route route;
    for (std::uint32_t place = from; place <= to; ++place) route.places.push_back(run.place(place));
    return route;
  }
  Route order() { return site.last<msg::RouteOrder>().value().route; }
  std::string why() { return site.goal(1).history.back().cause; }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r2"};
  TaughtRun run{r1, 10};
};

TEST_F(Capacity, ARouteEndsBeforeASetThatIsFull) {
  const HeldPlaces inside{{r2.id, {run.place(40)}}};
  const HeldPlaces outside{{r2.id, {run.place(41)}}};
  const ReleasedByRules full = released_by_capacity(rules(), along(10, 50), 0, 40, inside);
  EXPECT_EQ(full.through, 9U);
  EXPECT_EQ(full.rule, "room");
  const ReleasedByRules free = released_by_capacity(rules(), along(10, 50), 0, 40, outside);
  EXPECT_EQ(free.through, 40U);
  EXPECT_EQ(free.rule, "");
}

TEST_F(Capacity, AsManyAsItSaysAreLetIn) {
  put(2);
  const HeldPlaces one{{r2.id, {run.place(40)}}};
  EXPECT_EQ(released_by_capacity(rules(), along(10, 50), 0, 40, one).through, 40U);
  const HeldPlaces two{{r2.id, {run.place(40)}}, {robot_id(3), {run.place(19), run.place(20)}}};
  EXPECT_EQ(released_by_capacity(rules(), along(10, 50), 0, 40, two).through, 9U);
}

TEST_F(Capacity, WhoIsInsideMayLeave) {
  const HeldPlaces inside{{r2.id, {run.place(40)}}};
  EXPECT_EQ(released_by_capacity(rules(), along(25, 50), 0, 25, inside).through, 25U);
}

TEST_F(Capacity, WhoStandsRightBeforeItIsReleasedNoFarther) {
  const HeldPlaces inside{{r2.id, {run.place(40)}}};
  const ReleasedByRules full = released_by_capacity(rules(), along(10, 50), 9, 40, inside);
  EXPECT_FALSE(full.through);
  EXPECT_EQ(full.rule, "room");
  EXPECT_EQ(released_by_capacity(rules(), along(10, 50), 9, std::nullopt, inside).rule, "room")
      << "it is the next thing, also where others are in the way";
}

TEST_F(Capacity, TheNextOneWaitsBeforeItAndNamesTheRule) {
  site.arrive(r2, std::nullopt);
  stand(r2, run.place(38));
  site.send_goal(1, "end", "r1");
  site.pass(1s);
  const Route route = order();
  EXPECT_LT(route.released, 20U);
  EXPECT_GE(route.released, 14U);
  EXPECT_THAT(why(), HasSubstr("r1 waits until rule room lets it on"));
  site.progress(r1, route, msg::RoutePhase::waiting);
  site.pass(3s);
  msg::Query query;
  query.header = site.client.header();
  site.say(query);
  EXPECT_EQ(site.last<msg::QueryReply>().value().robots.at(0).wait.rule, "room");
  stand(r2, run.place(59));
  site.pass(3s);
  EXPECT_GE(order().released, 20U);
}

}  // namespace
}  // namespace weft::server::test
