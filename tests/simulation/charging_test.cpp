#include <gtest/gtest.h>

#include <algorithm>

#include "tests/simulation/operator.hpp"

/// Tests a battery, its reports, a rule on the map, the server's goal and a body that charges where the simulation
/// has a charger: together, without faults.
namespace weft::simulation {
namespace {
using namespace std::chrono_literals;

struct ChargingLife : testing::Test {
  msg::RobotPower power() {
    msg::Query query;
    query.kind = msg::Query::Kind::robots;
    fleet.take_answers();
    fleet.send(query);
    people.pass(2s);
    const std::vector<msg::QueryReply> answers = fleet.take_answers();
    return answers.empty() || answers.back().robots.empty() ? msg::RobotPower{} : answers.back().robots[0].power;
  }
  std::vector<Goal> charges() {
    std::vector<Goal> found;
    for (const auto& [id, goal] : fleet.disk().goals) {
      if (goal.kind == GoalKind::charge) found.push_back(goal);
    }
    return found;
  }

  Random random{7};
  Fleet fleet{FleetConfig{.site = "ring", .seed = 7, .robots = 1, .map = MapFrom::taught}};
  Chaos chaos{fleet, random.fork(1)};
  Operator people{fleet, chaos, random.fork(2), People::help, Focus::none};
};

TEST_F(ChargingLife, ARobotThatIsLowDrivesToTheChargerAndCharges) {
  ASSERT_TRUE(people.begin(MapFrom::taught)) << people.trouble();
  people.pass(5min);
  EXPECT_FALSE(power().header.sender) << "a body without a battery says nothing";
  msg::OperatorRequest charger;
  charger.request = 1'000'000;
  charger.kind = msg::OperatorRequest::Kind::rule_put;
  charger.rule = {.name = "plug", .kind = RuleKind::charging, .label = "station-0"};
  fleet.send(charger);
  const Pose2 plug = fleet.site().station(0);
  fleet.equip(0, agents::Battery({.share = 0.2, .charges_per_s = 0.002, .chargers = {{plug.x, plug.y}}}));
  people.pass(15min);
  const Pose2& there = fleet.body(0).site_from_robot();
  EXPECT_LT((there.translation() - plug.translation()).norm(), 0.5);
  ASSERT_EQ(charges().size(), 1U);
  EXPECT_EQ(charges().front().state, GoalState::succeeded);
  EXPECT_GT(power().share, 0.6);
  for (const Violation& violation : fleet.ledger().violations()) ADD_FAILURE() << violation.what;
}

}  // namespace
}  // namespace weft::simulation
