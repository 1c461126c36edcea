#include "server/traffic/plan/lanes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "server/traffic/plan/move_plan.hpp"
#include "server/traffic/plan/plan_order.hpp"
#include "tests/server/headed_graph.hpp"

namespace weft::server::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

/// Draws a block on each side, and a lane between them.
const std::vector<std::string> kTwoBlocks = {"...     ...",  //
                                             ". ....... .",  //
                                             "...     ..."};

struct LanesTest : testing::Test {
  void draw(const std::vector<std::string>& rows) {
    graph.emplace(rows);
    lanes.emplace(*graph);
    pockets.emplace(*graph);
  }
  Lanes::Stand stand(int x, int y, Heading heading) const { return {graph->at(x, y, heading), 0}; }
  bool meet(const Lanes::Stand& one, const Lanes::Stand& other) { return lanes->meet(one, other); }

  /// Adds a robot; the earlier ones have waited longer.
  PlanRobot& put(Berth at) {
    robots.push_back({});
    robots.back().at = at;
    robots.back().waits_s = 100.0 - static_cast<double>(robots.size());
    return robots.back();
  }
  void put(Berth at, Berth goal) { put(at).goal = &distances.emplace_back(*graph, goal, 0, nothing); }
  const MovePlan& plan() { return made = plan_moves(*graph, *pockets, *lanes, robots, {.steps = 80, .handling = 2}); }
  bool comes_to(std::size_t robot, Berth berth) const {
    return std::any_of(made.moves[robot].begin(), made.moves[robot].end(),
                       [berth](const PlannedMove& move) { return move.arc->to == berth; });
  }

  std::optional<HeadedGraph> graph;
  std::optional<Lanes> lanes;
  std::optional<Pockets> pockets;
  const std::vector<Berth> nothing;
  std::deque<Distances> distances;
  std::vector<PlanRobot> robots;
  MovePlan made;
};

TEST_F(LanesTest, TwoInALaneMeetThatFaceEachOther) {
  draw(kTwoBlocks);
  EXPECT_TRUE(meet(stand(3, 1, Heading::east), stand(7, 1, Heading::west)));
  EXPECT_TRUE(meet(stand(7, 1, Heading::west), stand(3, 1, Heading::east)));
}

TEST_F(LanesTest, TwoThatDriveTheSameWayDoNot) {
  draw(kTwoBlocks);
  EXPECT_FALSE(meet(stand(3, 1, Heading::east), stand(7, 1, Heading::east)));
  EXPECT_FALSE(meet(stand(3, 1, Heading::west), stand(7, 1, Heading::east)));
}

TEST_F(LanesTest, NorDoesOneThatIsNotInTheLaneYet) {
  draw(kTwoBlocks);
  EXPECT_FALSE(meet(stand(0, 0, Heading::east), stand(7, 1, Heading::west)));
}

TEST_F(LanesTest, OneThatCanTurnAsideOnTheWayLetsTheOtherPass) {
  draw({"... ...    ...",  //
        ". .......... .",  //
        "...        ..."});
  EXPECT_FALSE(meet(stand(3, 1, Heading::east), stand(10, 1, Heading::west)));
  EXPECT_TRUE(meet(stand(8, 1, Heading::east), stand(10, 1, Heading::west))) << "it is past the loop";
}

TEST_F(LanesTest, ARingDrivenBothWaysIsALane) {
  draw({".....",  //
        ".   .",  //
        "....."});
  EXPECT_TRUE(meet(stand(1, 0, Heading::east), stand(3, 0, Heading::west)));
  EXPECT_TRUE(meet(stand(1, 0, Heading::east), stand(1, 2, Heading::east))) << "the other way round";
  EXPECT_FALSE(meet(stand(1, 0, Heading::east), stand(1, 2, Heading::west))) << "the same way round";
}

TEST_F(LanesTest, WhatShutsARobotInEndsWithTheLane) {
  draw({".......     .......",  //
        ". . . .     . . . .",  //
        ".......     .......",  //
        ". . . ....... . . .",  //
        ".......     .......",  //
        ". . . .     . . . .",  //
        ".......     ......."});
  const std::vector<Berth>& shutting = lanes->shut_in_by(stand(7, 3, Heading::east));
  EXPECT_THAT(shutting, Contains(graph->at(11, 3, Heading::west)));
  EXPECT_THAT(shutting, Not(Contains(graph->at(14, 2, Heading::west))));
  EXPECT_THAT(shutting, Not(Contains(graph->at(6, 3, Heading::west)))) << "it is behind";
  EXPECT_THAT(lanes->shut_in_by(stand(2, 2, Heading::east)), IsEmpty());
}

TEST_F(LanesTest, NobodyEntersTowardsOneThatComesOut) {
  draw(kTwoBlocks);
  put(graph->at(0, 0, Heading::north), graph->at(10, 2, Heading::south));
  put(graph->at(7, 1, Heading::west), graph->at(0, 2, Heading::west));
  plan();
  EXPECT_TRUE(comes_to(0, graph->at(10, 2, Heading::south)));
  EXPECT_TRUE(comes_to(1, graph->at(0, 2, Heading::west)));
}

TEST_F(LanesTest, TwoThatComeFromBothEndsPassInTurn) {
  draw(kTwoBlocks);
  put(graph->at(0, 0, Heading::north), graph->at(10, 2, Heading::south));
  put(graph->at(10, 0, Heading::north), graph->at(0, 2, Heading::south));
  plan();
  EXPECT_TRUE(comes_to(0, graph->at(10, 2, Heading::south)));
  EXPECT_TRUE(comes_to(1, graph->at(0, 2, Heading::south)));
}

TEST_F(LanesTest, IdleOneInTheLaneIsSentOnOutOfIt) {
  draw(kTwoBlocks);
  put(graph->at(0, 0, Heading::north), graph->at(10, 2, Heading::south));
  put(graph->at(6, 1, Heading::west));
  plan();
  EXPECT_TRUE(comes_to(0, graph->at(10, 2, Heading::south)));
}

TEST_F(LanesTest, WhoStandsWhereTheLaneEndsDrivesOnRoundTheBlock) {
  draw(kTwoBlocks);
  put(graph->at(2, 1, Heading::south), graph->at(10, 2, Heading::south));
  put(graph->at(3, 1, Heading::west), graph->at(0, 2, Heading::west));
  plan();
  EXPECT_TRUE(comes_to(0, graph->at(10, 2, Heading::south)));
  EXPECT_TRUE(comes_to(1, graph->at(0, 2, Heading::west)));
}

TEST_F(LanesTest, WhoStandsBeforeALaneWaitsForTheOneInIt) {
  draw(kTwoBlocks);
  put(graph->at(2, 0, Heading::east), graph->at(10, 2, Heading::south));
  put(graph->at(7, 1, Heading::west), graph->at(0, 2, Heading::south));
  robots[1].stays = true;
  robots[0].at = graph->at(1, 0, Heading::east);
  EXPECT_THAT(plan().kept_by[0], IsEmpty()) << "it drives to the lane first";
  robots[0].at = graph->at(2, 1, Heading::south);
  EXPECT_THAT(plan().kept_by[0], ElementsAre(1U));
}

TEST_F(LanesTest, OneIsNotReleasedIntoALaneBeforeTheOtherIsReleasedOutOfIt) {
  draw(kTwoBlocks);
  put(graph->at(0, 1, Heading::south), graph->at(10, 2, Heading::south));
  put(graph->at(5, 1, Heading::west), graph->at(0, 0, Heading::north));
  PlanOrder order(plan());
  const auto enters = [&] {
    const std::uint32_t may = order.may(0);
    return may > 0 && std::any_of(order.moves(0).begin(), order.moves(0).begin() + may, [&](const PlannedMove& move) {
             return move.arc->to == graph->at(4, 1, Heading::east);
           });
  };
  EXPECT_FALSE(enters()) << "the other one has not moved";
  order.release(0, order.may(0));
  EXPECT_THAT(order.waits_for(0), ElementsAre(1U));
  order.release(1, static_cast<std::uint32_t>(order.moves(1).size()));
  EXPECT_TRUE(enters());
}

}  // namespace
}  // namespace weft::server::test
