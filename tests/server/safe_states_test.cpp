#include "server/traffic/plan/safe_states.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/headed_graph.hpp"

namespace weft::server::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

/// A crossing of four lanes for one robot; at the far end of each robots drive round a block and come back. Two can
/// do so in the south.
std::vector<std::string> crossing() {
  std::vector<std::string> rows(23, std::string(19, ' '));
  for (const auto& [left, top] : {std::pair(0, 7), {14, 7}, {7, 0}, {7, 14}, {7, 18}}) {
    for (int y = top; y < top + 5; ++y) {
      for (int x = left; x < left + 5; ++x) {
        const bool is_side = x == left || x == left + 4 || y == top || y == top + 4;
        if (is_side) rows[y][x] = '.';
      }
    }
  }
  for (int i = 5; i < 14; ++i) rows[9][i] = rows[i][9] = '.';
  return rows;
}

struct SafeStatesTest : testing::Test {
  Berth west() const { return graph.at(6, 9, Heading::east); }
  Berth east() const { return graph.at(12, 9, Heading::west); }
  Berth north() const { return graph.at(9, 6, Heading::south); }
  Berth south() const { return graph.at(9, 12, Heading::north); }
  Berth southern_block() const { return graph.at(7, 20, Heading::south); }

  HeadedGraph graph{crossing()};
  Lanes lanes{graph};
  SafeStates states{graph, lanes};
};

TEST_F(SafeStatesTest, TwoBeforeACrossingLeaveALaneForAThird) {
  states.add({west(), 0});
  states.add({east(), 0});
  states.add({southern_block(), 0});
  EXPECT_THAT(states.stuck_by(2, south(), {}), IsEmpty());
  EXPECT_THAT(states.kept_by(2, south()), IsEmpty());
}

TEST_F(SafeStatesTest, NobodyDrivesIntoTheLastOfTheFourLanesThoughNoTwoMeet) {
  states.add({west(), 0});
  states.add({east(), 0});
  states.add({north(), 0});
  states.add({southern_block(), 0});
  for (const Berth other : {west(), east(), north()}) EXPECT_FALSE(lanes.meet({south(), 0}, {other, 0}));
  EXPECT_THAT(states.stuck_by(3, south(), {}), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(states.kept_by(3, south()), ElementsAre(0, 1, 2, 3));
}

TEST_F(SafeStatesTest, WhoLeavesIsNotLookedAt) {
  states.add({west(), 0});
  states.add({east(), 0});
  states.add({north(), 0});
  states.add({southern_block(), 0});
  EXPECT_THAT(states.stuck_by(3, south(), {1}), IsEmpty());
  EXPECT_THAT(states.stuck_by(3, south(), {}), ElementsAre(0, 1, 2, 3)) << "it is back where it stands";
}

TEST_F(SafeStatesTest, WaysOverWhereOneLeavesAreForgottenWhenItIsBack) {
  states.add({west(), 0});
  states.add({east(), 0});
  states.add({north(), 0});
  states.add({southern_block(), 0});
  states.add({graph.at(9, 11, Heading::south), 0});
  ASSERT_THAT(states.stuck_by(3, graph.at(9, 13, Heading::north), {1}), Contains(4)) << "they are face to face";
  states.put(4, kNoBerth);
  EXPECT_THAT(states.stuck_by(3, south(), {}), ElementsAre(0, 1, 2, 3));
}

TEST_F(SafeStatesTest, WhatWasRefusedIsAllowedOnceOneHasLeft) {
  states.add({west(), 0});
  states.add({east(), 0});
  states.add({north(), 0});
  states.add({southern_block(), 0});
  ASSERT_FALSE(states.stuck_by(3, south(), {}).empty());
  states.put(2, graph.at(11, 20, Heading::south));
  EXPECT_THAT(states.stuck_by(3, south(), {}), IsEmpty());
  states.put(2, north());
  EXPECT_FALSE(states.stuck_by(3, south(), {}).empty());
}

TEST_F(SafeStatesTest, ThoseThatAreStuckAlreadyKeepNobody) {
  states.add({west(), 0});
  states.add({east(), 0});
  states.add({north(), 0});
  states.add({south(), 0});
  EXPECT_THAT(states.stuck_by(3, graph.at(9, 11, Heading::north), {}), IsEmpty());
}

TEST_F(SafeStatesTest, GridlockedRobotsMayBeStuckByOneOfThem) {
  states.add({west(), 0}, true);
  states.add({east(), 0});
  states.add({north(), 0}, true);
  states.add({southern_block(), 0}, true);
  EXPECT_THAT(states.stuck_by(3, south(), {}), ElementsAre(1)) << "it is not gridlocked itself";
}

TEST_F(SafeStatesTest, WhoIsNowhereIsInNobodysWay) {
  states.add({west(), 0});
  states.add({east(), 0});
  states.add({kNoBerth, 0});
  states.add({southern_block(), 0});
  EXPECT_THAT(states.stuck_by(3, south(), {}), IsEmpty());
}

}  // namespace
}  // namespace weft::server::test
