#include "server/traffic/plan/gridlock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/headed_graph.hpp"

namespace weft::server::test {
namespace {

using testing::Each;
using testing::ElementsAre;

/// Arranges four robots with goals that do not move.
struct GridlockTest : testing::Test {
  GridlockTest() {
    plan.moves.resize(4);
    plan.kept_by.resize(4);
    for (Berth berth = 0; berth < 4; ++berth) {
      PlanRobot robot;
      robot.at = berth;
      robot.goal = &goal;
      robots.push_back(robot);
    }
  }
  std::vector<bool> locked() const { return gridlocked(plan, robots); }
  void moves(std::size_t robot) { plan.moves[robot].emplace_back(); }

  HeadedGraph graph{{"...."}};
  std::vector<Berth> nothing;
  Distances goal{graph, 0, 0, nothing};
  MovePlan plan;
  std::vector<PlanRobot> robots;
};

TEST_F(GridlockTest, RobotsThatKeepOneAnotherAreLocked) {
  plan.kept_by = {{1}, {2}, {0}, {}};
  EXPECT_THAT(locked(), ElementsAre(true, true, true, false));
}

TEST_F(GridlockTest, WhoWaitsForOneThatMovesIsNotNorWhoWaitsForThat) {
  plan.kept_by = {{1}, {0, 2}, {3}, {}};
  moves(3);
  EXPECT_THAT(locked(), Each(false));
}

TEST_F(GridlockTest, WhoWaitsForOneThatCannotMoveIsNot) {
  plan.kept_by = {{1}, {0, 2}, {}, {}};
  robots[2].goal = nullptr;
  robots[2].stays = true;
  EXPECT_THAT(locked(), Each(false));
  robots[2].stays = false;
  robots[2].handles = 3;
  EXPECT_THAT(locked(), Each(false));
}

TEST_F(GridlockTest, AnIdleRobotIsLockedWithThoseThatItKeeps) {
  plan.kept_by = {{1}, {}, {}, {}};
  robots[1].goal = robots[2].goal = nullptr;
  EXPECT_THAT(locked(), ElementsAre(true, true, false, false));
}

TEST_F(GridlockTest, SomeKeepOthersAlsoByOneThatHasNothingToDo) {
  plan.kept_by = {{1}, {2}, {}, {}};
  robots[1].goal = nullptr;
  EXPECT_TRUE(keep_others(plan, robots, {false, false, true, false}));
  EXPECT_FALSE(keep_others(plan, robots, {false, false, false, true}));
  EXPECT_FALSE(keep_others(plan, robots, {true, false, true, false})) << "only one of themselves";
  moves(1);
  EXPECT_FALSE(keep_others(plan, robots, {false, false, true, false}));
}

}  // namespace
}  // namespace weft::server::test
