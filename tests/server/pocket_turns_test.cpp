#include "server/traffic/plan/pocket_turns.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "tests/server/drawn_graph.hpp"

namespace weft::server::test {
namespace {

/// A one-way ring that comes by the mouth of a dead end, in which one robot wants to go; an idle one stands in the
/// mouth.
struct PocketTurnsTest : testing::Test {
  PocketTurnsTest() {
    graph.one_way(graph.at(1, 0), mouth);
    graph.one_way(mouth, graph.at(1, 2));
    pocket = pockets.look(deep, 0);
    wanting.at = graph.at(0, 0);
    wanting.goal = &distances.emplace_back(graph, deep, 0, occupied);
    wanting.pocket = pocket;
    idle.at = mouth;
  }
  /// Returns whether the idle robot may go into the dead end.
  bool may_go_in(bool is_asked) {
    PocketTurns turns(pockets);
    turns.begin_step();
    turns.is_at(idle.at, 1);
    turns.wants(0, wanting);
    return turns.may_go(1, idle, graph.at(2, 1), is_asked);
  }

  DrawnGraph graph{{"..  ",  //
                    "....",  //
                    "..  "}};
  Berth mouth = graph.at(1, 1);
  Berth deep = graph.at(3, 1);
  Pockets pockets{graph};
  std::uint32_t pocket = Pockets::kNone;
  std::vector<Berth> occupied;
  std::deque<Distances> distances;
  PlanRobot wanting;
  PlanRobot idle;
};

TEST_F(PocketTurnsTest, NobodyMakesWayIntoAPocketThatAnotherWants) {
  ASSERT_NE(pocket, Pockets::kNone);
  EXPECT_FALSE(may_go_in(true));
  EXPECT_FALSE(may_go_in(false));
}

TEST_F(PocketTurnsTest, UnlessThereIsNoOtherWayOn) {
  graph.one_way(graph.at(1, 2), mouth);
  graph.one_way(graph.at(0, 1), mouth);
  ASSERT_TRUE(pockets.leads_only_into(pocket, mouth, 0));
  EXPECT_TRUE(may_go_in(true));
  EXPECT_TRUE(may_go_in(false));
}

}  // namespace
}  // namespace weft::server::test
