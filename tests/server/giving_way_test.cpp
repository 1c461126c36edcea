#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>

#include "server/traffic/plan/gridlock.hpp"
#include "server/traffic/plan/move_plan.hpp"
#include "tests/server/headed_graph.hpp"

namespace weft::server::test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

/// Draws a crossing of four lanes; at the far end of each robots drive round a block and come back.
std::vector<std::string> lanes_with_blocks() {
  std::vector<std::string> rows(25, std::string(25, ' '));
  for (const auto& [left, top] : {std::pair(0, 10), {20, 10}, {10, 0}, {10, 20}}) {
    for (int y = top; y < top + 5; ++y) {
      for (int x = left; x < left + 5; ++x) {
        if (x == left || x == left + 4 || y == top || y == top + 4) rows[y][x] = '.';
      }
    }
  }
  for (int i = 5; i < 20; ++i) rows[12][i] = rows[i][12] = '.';
  rows[12][12] = '+';
  return rows;
}

/// Arranges two robots before the crossing, of which each wants into the lane where the other one stands; the one in
/// the east has waited longer.
struct GivingWayTest : testing::Test {
  GivingWayTest() {
    put(east, north_block);
    put(north, east_block);
  }
  void put(Berth at, Berth goal) {
    PlanRobot robot;
    robot.at = at;
    robot.goal = &distances.emplace_back(graph, goal, 0, nothing);
    robot.waits_s = 100.0 - static_cast<double>(robots.size());
    robots.push_back(robot);
  }
  const MovePlan& plan() { return made = plan_moves(graph, pockets, lanes, robots, {.steps = 80, .handling = 2}); }
  /// Returns the drives across the crossing from the north, into the lane that is free.
  std::vector<Berth> south_lane() const {
    constexpr int straight = 5;  // comes and leaves southwards
    return {graph.at(12, 12, static_cast<Heading>(straight)), graph.at(12, 13, Heading::south),
            graph.at(12, 14, Heading::south)};
  }
  LedAway led_away() {
    SafeStates states(graph, lanes);
    for (const PlanRobot& robot : robots) states.add({robot.at, robot.methods});
    return led_away_of(states, made, robots, {true, true}, [this](std::uint32_t robot) { return led_at[robot]; });
  }
  bool comes_to(std::size_t robot, Berth berth) const {
    return std::any_of(made.moves[robot].begin(), made.moves[robot].end(),
                       [berth](const PlannedMove& move) { return move.arc->to == berth; });
  }

  HeadedGraph graph{lanes_with_blocks()};
  Lanes lanes{graph};
  Pockets pockets{graph};
  const Berth east = graph.at(13, 12, Heading::west);
  const Berth north = graph.at(12, 11, Heading::south);
  const Berth east_block = graph.at(22, 10, Heading::east);
  const Berth north_block = graph.at(12, 0, Heading::east);
  const std::vector<Berth> nothing;
  std::deque<Distances> distances;
  std::vector<PlanRobot> robots;
  std::array<std::uint64_t, 2> led_at = {};
  MovePlan made;
};

TEST_F(GivingWayTest, RobotsThatWantIntoEachOthersLanesAreGridlocked) {
  plan();
  EXPECT_THAT(made.moves, Each(IsEmpty()));
  EXPECT_THAT(gridlocked(made, robots), ElementsAre(true, true));
}

TEST_F(GivingWayTest, TheOneThatGoesAfterTheOtherLetsItPastAndComesToItsGoalToo) {
  for (PlanRobot& robot : robots) robot.gives_way = true;
  plan();
  EXPECT_TRUE(comes_to(0, north_block));
  EXPECT_TRUE(comes_to(1, east_block));
  ASSERT_FALSE(made.moves[1].empty());
  EXPECT_EQ(made.moves[1].front().step, 0U) << "it goes aside first";
}

TEST_F(GivingWayTest, TheOneThatGoesFirstDoesNotGiveWay) {
  robots[0].gives_way = true;
  EXPECT_THAT(plan().moves, Each(IsEmpty()));
}

TEST_F(GivingWayTest, WhoIsLedAwayDrivesThereBeforeAllOthersAndToItsGoalAfterwards) {
  robots[1].led_over = south_lane();
  plan();
  std::vector<Berth> first;
  for (std::size_t i = 0; i < 3 && i < made.moves[1].size(); ++i) first.push_back(made.moves[1][i].arc->to);
  EXPECT_EQ(first, south_lane());
  EXPECT_EQ(made.moves[1].front().step, 0U);
  EXPECT_TRUE(comes_to(0, north_block));
  EXPECT_TRUE(comes_to(1, east_block));
}

TEST_F(GivingWayTest, TheOneThatWaitedLessIsLedAwayUnlessItWasLedBefore) {
  plan();
  EXPECT_EQ(led_away().robot, 1U);
  EXPECT_EQ(led_away().over.size(), 6U);
  led_at[1] = 1;
  EXPECT_EQ(led_away().robot, 0U);
  led_at[0] = 2;
  EXPECT_EQ(led_away().robot, 1U) << "the other one was led after it";
}

TEST_F(GivingWayTest, AnIdleRobotIsLedAwayToo) {
  plan();
  robots[0].goal = nullptr;
  robots[0].waits_s = 0.0;
  EXPECT_EQ(led_away().robot, 0U);
}

TEST_F(GivingWayTest, WhoKeepsOthersIsLedAwayBeforeWhoKeepsNobody) {
  plan();
  made.kept_by = {{1}, {}};
  robots[0].waits_s = 1.0;
  EXPECT_EQ(led_away().robot, 1U);
  led_at[1] = 1;
  EXPECT_EQ(led_away().robot, 0U) << "that may be what shuts in the other one";
}

TEST_F(GivingWayTest, NobodyIsLedAwayWhoStaysOrCannotDriveThere) {
  plan();
  robots[0].stays = true;
  EXPECT_EQ(led_away().robot, 1U);
  robots[1].avoids = {led_away().over.front()};
  EXPECT_EQ(led_away().robot, kNobody);
}

}  // namespace
}  // namespace weft::server::test
