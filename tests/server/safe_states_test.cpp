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
  /// Is where one ends that has come from the west and has driven so many berths down the southern lane.
  Berth south_of_west(int berths) const { return graph.at(9, 9 + berths, Heading::south); }
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

TEST_F(SafeStatesTest, AGridlockedRobotDoesNotShutItselfInAmongOthers) {
  states.add({west(), 0}, true);
  states.add({east(), 0});
  states.add({north(), 0}, true);
  states.add({southern_block(), 0}, true);
  EXPECT_THAT(states.stuck_by(3, south(), {}), ElementsAre(0, 1, 2, 3));
}

/// Behind the crossing's last free lane, with all four lanes taken: a spur leads into the southern blocks, in which a
/// robot can get to just as many berths as one that gets away, and from the spur's end on to one less.
struct SpurTest : SafeStatesTest {
  static std::vector<std::string> with_spur() {
    std::vector<std::string> rows = crossing();
    rows[20][12] = '.';
    return rows;
  }
  void arrange(bool is_gridlocked) {
    for (const Lanes::Stand& stand : {at(6, 9, Heading::east), at(12, 9, Heading::west), at(9, 6, Heading::south)})
      around.add(stand, is_gridlocked);
    around.add(at(12, 20, Heading::west), is_gridlocked);
    around.add(at(9, 12, Heading::north), is_gridlocked);
  }
  Lanes::Stand at(int x, int y, Heading heading) const { return {spur.at(x, y, heading), 0}; }

  HeadedGraph spur{with_spur()};
  Lanes spur_lanes{spur};
  SafeStates around{spur, spur_lanes};
};

TEST_F(SpurTest, WhoHasALittleLessBeforeItIsStuck) {
  arrange(false);
  EXPECT_THAT(around.stuck_by(3, at(11, 20, Heading::west).berth, {}), ElementsAre(3, 4));
}

TEST_F(SpurTest, AGridlockedRobotMayStandWhereItGetsHalfAsFar) {
  arrange(true);
  EXPECT_THAT(around.stuck_by(3, at(11, 20, Heading::west).berth, {}), IsEmpty());
}

TEST_F(SafeStatesTest, WhoGetsPastTheOthersHasAWayOut) {
  states.add({west(), 0});
  states.add({east(), 0});
  states.add({north(), 0});
  const std::vector<Berth> way = states.way_out(0, 6);
  ASSERT_EQ(way.size(), 6U);
  EXPECT_EQ(way.back(), south_of_west(3)) << "down the lane that is left";
  EXPECT_TRUE(states.is_way_out(0, way));
  states.put(0, way[2]);
  EXPECT_TRUE(states.is_way_out(0, {way.begin() + 3, way.end()}));
  EXPECT_FALSE(states.is_way_out(0, way)) << "it does not begin where the robot stands";
  states.put(1, way[4]);
  EXPECT_FALSE(states.is_way_out(0, {way.begin() + 3, way.end()})) << "somebody stands there";
}

TEST_F(SafeStatesTest, WhoIsShutInOrNowhereHasNoWayOut) {
  for (const Berth berth : {west(), east(), north(), south(), kNoBerth}) states.add({berth, 0});
  for (std::uint32_t robot = 0; robot < 5; ++robot) EXPECT_THAT(states.way_out(robot, 6), IsEmpty());
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
