#include <gtest/gtest.h>

#include <algorithm>

#include "tests/simulation/operator.hpp"

/// Tests what people do for a robot that a run by hand has left beside all lanes.
namespace weft::simulation {
namespace {
using namespace std::chrono_literals;

struct DeadEndLife : testing::Test {
  void ask(msg::OperatorRequest request) {
    request.request = ++asked + 1'000'000;
    request.robot = fleet.name(0);
    fleet.send(request);
    people.pass(2s);
  }
  /// Teaches a run that turns off to the left where the robot stands, and ends there.
  void teach_off_the_lane() {
    const Pose2 here = fleet.body(0).site_from_robot();
    const Eigen::Vector2d beside = here * Eigen::Vector2d(1.5, 1.8);
    const Eigen::Vector2d end = here * Eigen::Vector2d(3.0, 1.8);
    msg::OperatorRequest start;
    start.kind = msg::OperatorRequest::Kind::teach_start;
    start.label = "aside";
    start.along = {{here.x, here.y}, {beside.x(), beside.y()}, {end.x(), end.y()}};
    ask(start);
    people.pass(60s);
    ASSERT_FALSE(fleet.body(0).by_hand());
    msg::OperatorRequest stop;
    stop.kind = msg::OperatorRequest::Kind::teach_stop;
    ask(stop);
    people.pass(10s);
  }
  /// Has people do things until one of their goals is open. Returns whether one is.
  bool sends_a_goal() {
    for (int i = 0; i < 50 && people.open_goals() == 0; ++i) people.errand();
    return people.open_goals() > 0;
  }

  Random random{7};
  Fleet fleet{FleetConfig{.site = "ring", .seed = 7, .robots = 1, .map = MapFrom::taught}};
  Chaos chaos{fleet, random.fork(1)};
  Operator people{fleet, chaos, random.fork(2), People::help, Focus::none};
  std::uint64_t asked = 0;
};

TEST_F(DeadEndLife, PeopleTeachAWayOnFromThere) {
  ASSERT_TRUE(people.begin(MapFrom::taught)) << people.trouble();
  people.pass(5min);
  people.help();
  ASSERT_EQ(people.open_goals(), 0U);
  teach_off_the_lane();
  ASSERT_TRUE(sends_a_goal());
  people.pass(20s);
  for (const SteadyTime end = fleet.now() + 20min; fleet.now() < end && people.open_goals() > 0; people.pass(20s)) {
    people.help();
  }
  EXPECT_EQ(people.open_goals(), 0U);
  const auto& goals = fleet.disk().goals;
  const auto waited = [](const auto& known) {
    return std::ranges::any_of(known.second.history,
                               [](const GoalEvent& event) { return event.cause.starts_with("no path from "); });
  };
  EXPECT_EQ(std::ranges::count_if(goals, waited), 1);
  for (const auto& [id, goal] : goals) EXPECT_NE(goal.state, GoalState::failed) << goal.history.back().cause;
  for (const Violation& violation : fleet.ledger().violations()) ADD_FAILURE() << violation.what;
}

}  // namespace
}  // namespace weft::simulation
