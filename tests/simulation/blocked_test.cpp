#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/simulation/operator.hpp"

/// Tests a base that stands before a crate, the agent that notices it, the server that closes the floor there for the
/// goal, and the way round: together, without faults.
namespace weft::simulation {
namespace {
using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;

/// Arranges one robot on the ring, which has come to station 1. A crate stands before that, on the way to station 2.
struct BlockedLife : testing::Test {
  BlockedLife() {
    EXPECT_TRUE(people.begin(MapFrom::taught)) << people.trouble();
    people.pass(5min);
    EXPECT_EQ(driven_to("station-1", 10min), GoalState::succeeded);
  }
  void ask(msg::OperatorRequest::Kind kind, const std::string& label,
           const std::vector<agents::SitePoint>& along = {}) {
    msg::OperatorRequest request;
    request.request = ++asked + 1'000'000;
    request.kind = kind;
    request.robot = fleet.name(0);
    request.label = label;
    for (const agents::SitePoint& point : along) request.along.push_back({point.x, point.y});
    if (kind == msg::OperatorRequest::Kind::goal_send) request.goal.bytes[0] = static_cast<std::uint8_t>(asked);
    fleet.send(request);
    people.pass(2s);
  }
  /// Teaches a way that turns off to the left where the robot stands, leads past the crate, and joins the ring again.
  void teach_way_round() {
    const Pose2 here = fleet.body(0).site_from_robot();
    const auto point = [&](double along_m, double left_m) {
      const Eigen::Vector2d at = fleet.site().station(1) * Eigen::Vector2d(along_m, left_m);
      return agents::SitePoint{at.x(), at.y()};
    };
    ask(msg::OperatorRequest::Kind::teach_start, "round",
        {{here.x, here.y}, point(0.0, 1.0), point(0.0, 1.8), point(2.0, 1.8), point(3.5, 1.8), point(5.0, 1.8)});
    people.pass(60s);
    ASSERT_FALSE(fleet.body(0).by_hand());
    ask(msg::OperatorRequest::Kind::teach_stop, "");
    people.pass(10s);
  }
  const Goal& goal() { return fleet.disk().goals.at(latest); }
  void send(const std::string& label) {
    ask(msg::OperatorRequest::Kind::goal_send, label);
    latest = GoalId{};
    latest.bytes[0] = static_cast<std::uint8_t>(asked);
  }
  /// Returns how the goal stands after so long, or when it is over.
  GoalState after(Duration time) {
    for (const SteadyTime end = fleet.now() + time; fleet.now() < end && !is_terminal(goal().state);) people.pass(2s);
    return goal().state;
  }
  GoalState driven_to(const std::string& label, Duration at_most) {
    send(label);
    return after(at_most);
  }
  std::vector<std::string> causes() {
    std::vector<std::string> all;
    for (const GoalEvent& event : goal().history) all.push_back(event.cause);
    return all;
  }
  void put_crate() {
    const Eigen::Vector2d crate = fleet.site().station(1) * Eigen::Vector2d(0.65, 0.0);
    fleet.put_crate(0, crate);
  }
  void expect_nothing_broken() {
    for (const Violation& violation : fleet.ledger().violations()) ADD_FAILURE() << violation.what;
  }

  Random random{7};
  Fleet fleet{FleetConfig{.site = "ring", .seed = 7, .robots = 1, .map = MapFrom::taught}};
  Chaos chaos{fleet, random.fork(1)};
  Operator people{fleet, chaos, random.fork(2), People::help, Focus::none};
  int asked = 0;
  GoalId latest;
};

TEST_F(BlockedLife, ARobotBeforeACrateGoesRound) {
  teach_way_round();
  ASSERT_EQ(driven_to("station-0", 10min), GoalState::succeeded);
  put_crate();
  EXPECT_EQ(driven_to("station-2", 5min), GoalState::succeeded);
  EXPECT_THAT(causes(), Contains(HasSubstr("r0 found the way blocked between")));
  EXPECT_THAT(causes(), Contains(HasSubstr("planned anew for r0")));
  expect_nothing_broken();
}

TEST_F(BlockedLife, WithNoWayRoundItSaysSoAndFinishesWhenTheCrateIsGone) {
  put_crate();
  send("station-2");
  EXPECT_EQ(after(5min), GoalState::executing);
  EXPECT_THAT(goal().history.back().cause, HasSubstr("no other way leads there: it waits"));
  fleet.take_crate(0);
  EXPECT_EQ(after(8min), GoalState::succeeded);
  EXPECT_THAT(causes(), Contains(HasSubstr("the way is open again for this goal")));
  expect_nothing_broken();
}

}  // namespace
}  // namespace weft::simulation
