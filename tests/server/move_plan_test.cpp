#include "server/traffic/plan/move_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <set>

#include "server/traffic/plan/plan_order.hpp"
#include "tests/server/drawn_graph.hpp"

namespace weft::server::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

struct MovePlanTest : testing::Test {
  void draw(const std::vector<std::string>& rows) {
    graph.emplace(rows);
    pockets.emplace(*graph);
    lanes.emplace(*graph);
  }
  /// Adds a robot; the earlier ones have waited longer.
  PlanRobot& put(Berth at) {
    robots.push_back({});
    robots.back().at = at;
    robots.back().waits_s = 100.0 - static_cast<double>(robots.size());
    pockets->look(at, 0);
    return robots.back();
  }
  PlanRobot& put(Berth at, Berth goal) {
    PlanRobot& robot = put(at);
    robot.goal = &distances.emplace_back(*graph, goal, 0, occupied);
    robot.pocket = pockets->look(goal, 0);
    return robot;
  }
  const MovePlan& plan(std::uint32_t steps = 30) {
    made = plan_moves(*graph, *pockets, *lanes, robots, {.steps = steps, .handling = 2});
    expect_exclusive();
    return made;
  }
  /// Nobody enters where another one stands as the step begins, or enters, too.
  void expect_exclusive() const {
    std::vector<Berth> at;
    for (const PlanRobot& robot : robots) at.push_back(robot.at);
    for (std::uint32_t step = 0; step < 30; ++step) {
      const std::multiset<Berth> before(at.begin(), at.end());
      for (std::size_t i = 0; i < at.size(); ++i) {
        for (const PlannedMove& move : made.moves[i]) {
          if (move.step != step) continue;
          EXPECT_EQ(move.from, at[i]);
          EXPECT_EQ(before.count(move.arc->to), 0U) << "robot " << i << ", step " << step;
          at[i] = move.arc->to;
        }
      }
      EXPECT_EQ(std::set<Berth>(at.begin(), at.end()).size(), at.size()) << "step " << step;
    }
  }
  Berth end_of(std::size_t robot) const {
    return made.moves[robot].empty() ? robots[robot].at : made.moves[robot].back().arc->to;
  }
  bool comes_by(std::size_t robot, Berth berth) const {
    return std::any_of(made.moves[robot].begin(), made.moves[robot].end(),
                       [berth](const PlannedMove& move) { return move.arc->to == berth; });
  }

  std::optional<DrawnGraph> graph;
  std::optional<Pockets> pockets;
  std::optional<Lanes> lanes;
  std::vector<Berth> occupied;
  std::deque<Distances> distances;
  std::vector<PlanRobot> robots;
  MovePlan made;
};

TEST_F(MovePlanTest, ARobotAloneDrivesToItsGoal) {
  draw({"....."});
  put(graph->at(0, 0), graph->at(4, 0));
  EXPECT_THAT(plan().moves[0], SizeIs(4));
  EXPECT_EQ(end_of(0), graph->at(4, 0));
}

TEST_F(MovePlanTest, TwoHeadOnPassEachOtherRoundABlock) {
  draw({".....",  //
        ".   .",  //
        "....."});
  put(graph->at(1, 0), graph->at(3, 0));
  put(graph->at(3, 0), graph->at(1, 0));
  plan();
  EXPECT_TRUE(comes_by(0, graph->at(3, 0)));
  EXPECT_TRUE(comes_by(1, graph->at(1, 0)));
}

TEST_F(MovePlanTest, AnIdleRobotMakesWay) {
  draw({".....",  //
        "  .  "});
  put(graph->at(0, 0), graph->at(4, 0));
  put(graph->at(2, 0));
  plan();
  EXPECT_EQ(end_of(0), graph->at(4, 0));
  EXPECT_GE(made.pushes, 1U);
}

TEST_F(MovePlanTest, WhoStaysIsDrivenRoundAndNotAsked) {
  draw({".....",  //
        ". . .",  //
        "....."});
  occupied = {graph->at(2, 0)};
  put(graph->at(0, 0), graph->at(4, 0));
  put(graph->at(2, 0)).stays = true;
  plan();
  EXPECT_THAT(made.moves[1], IsEmpty());
  EXPECT_EQ(end_of(0), graph->at(4, 0));
}

TEST_F(MovePlanTest, WhoStaysKeepsWhatItHolds) {
  draw({"....."});
  put(graph->at(0, 0), graph->at(2, 0));
  PlanRobot& dead = put(graph->at(4, 0));
  dead.behind = {graph->at(2, 0), graph->at(3, 0)};
  dead.stays = true;
  plan();
  EXPECT_EQ(end_of(0), graph->at(1, 0));
}

TEST_F(MovePlanTest, AnIdleRobotDoesNotMakeWayIntoWhatOneThatStaysHolds) {
  draw({"......",  //
        "  .   "});
  put(graph->at(0, 0), graph->at(2, 0));
  put(graph->at(2, 0));
  PlanRobot& dead = put(graph->at(5, 0));
  dead.behind = {graph->at(3, 0), graph->at(4, 0)};
  dead.stays = true;
  plan();
  EXPECT_EQ(end_of(1), graph->at(2, 1));
  EXPECT_EQ(end_of(0), graph->at(2, 0));
}

TEST_F(MovePlanTest, ARingThatIsFullButOneGoesRound) {
  draw({"...",  //
        ". .",  //
        "..."});
  const std::vector<Berth> ring = {graph->at(0, 0), graph->at(1, 0), graph->at(2, 0), graph->at(2, 1),
                                   graph->at(2, 2), graph->at(1, 2), graph->at(0, 2), graph->at(0, 1)};
  for (std::size_t i = 0; i < ring.size(); ++i) graph->one_way(ring[i], ring[(i + 1) % ring.size()]);
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) put(ring[i], ring[(i + 2) % ring.size()]);
  plan();
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) EXPECT_TRUE(comes_by(i, ring[(i + 2) % ring.size()])) << i;
}

TEST_F(MovePlanTest, WhoIsStillDrivingHoldsWhatItDrivesThrough) {
  draw({".....",  //
        "  .  "});
  put(graph->at(2, 1), graph->at(2, 0));
  PlanRobot& driving = put(graph->at(4, 0));
  driving.behind = {graph->at(1, 0), graph->at(2, 0), graph->at(3, 0)};
  plan();
  ASSERT_THAT(made.moves[0], SizeIs(1));
  EXPECT_EQ(made.moves[0].front().step, 2U);
}

/// A ring on which robots drive round, and a dead end of two berths.
struct PocketTest : MovePlanTest {
  PocketTest() {
    draw({".....  ",  //
          ".   ...",  //
          ".....  "});
    const std::vector<Berth> ring = {graph->at(0, 0), graph->at(1, 0), graph->at(2, 0), graph->at(3, 0),
                                     graph->at(4, 0), graph->at(4, 1), graph->at(4, 2), graph->at(3, 2),
                                     graph->at(2, 2), graph->at(1, 2), graph->at(0, 2), graph->at(0, 1)};
    for (std::size_t i = 0; i < ring.size(); ++i) graph->one_way(ring[i], ring[(i + 1) % ring.size()]);
  }
  Berth mouth() const { return graph->at(4, 1); }
  Berth deep() const { return graph->at(6, 1); }
};

TEST_F(PocketTest, ADeadEndIsOneAndTheRingIsNot) {
  const std::uint32_t pocket = pockets->look(deep(), 0);
  ASSERT_NE(pocket, Pockets::kNone);
  EXPECT_EQ(pockets->of(graph->at(5, 1)), pocket);
  EXPECT_EQ(pockets->of(mouth()), Pockets::kNone);
  EXPECT_TRUE(pockets->is_at_mouth(pocket, mouth()));
  EXPECT_EQ(pockets->look(graph->at(0, 0), 0), Pockets::kNone);
}

TEST_F(PocketTest, WhoLeavesGoesFirst) {
  put(mouth(), deep());
  put(deep(), graph->at(0, 0));
  plan();
  EXPECT_TRUE(comes_by(1, graph->at(0, 0)));
  EXPECT_TRUE(comes_by(0, deep()));
}

TEST_F(PocketTest, OnlyOneGoesInAndTheOtherDoesNotWaitInTheMouth) {
  put(graph->at(4, 0), deep());
  put(graph->at(3, 0), graph->at(5, 1));
  plan(4);
  EXPECT_EQ(end_of(0), deep());
  EXPECT_FALSE(comes_by(1, mouth()));
}

TEST_F(PocketTest, WhoHasArrivedInThereAndIsIdleComesOutForWhoWantsIn) {
  put(graph->at(3, 0), graph->at(5, 1));
  put(deep());
  plan();
  EXPECT_TRUE(comes_by(1, mouth()));
  EXPECT_TRUE(comes_by(0, graph->at(5, 1)));
}

/// An idle robot in the mouth, where another one is to go, and from where it cannot drive on: the ring is shut.
struct ShutRingTest : PocketTest {
  ShutRingTest() {
    pockets->look(deep(), 0);
    put(graph->at(3, 0), mouth());
    put(mouth());
    put(graph->at(4, 2)).stays = true;
  }
};

TEST_F(ShutRingTest, AnIdleRobotMakesWayIntoADeadEndThatNobodyWants) {
  plan();
  EXPECT_EQ(end_of(0), mouth());
  EXPECT_TRUE(comes_by(1, graph->at(5, 1)));
}

TEST_F(ShutRingTest, NotIntoOneThatAnotherWants) {
  put(graph->at(2, 0), deep());
  plan();
  EXPECT_FALSE(comes_by(1, graph->at(5, 1)));
}

TEST_F(PocketTest, AnIdleRobotDrivesOnRatherThanIntoADeadEnd) {
  pockets->look(deep(), 0);
  put(graph->at(3, 0), graph->at(4, 2));
  put(mouth());
  plan();
  EXPECT_FALSE(comes_by(1, graph->at(5, 1)));
  EXPECT_TRUE(comes_by(0, graph->at(4, 2)));
}

/// The first one wants to go where the second stands. That one cannot go where the third stands, who has no room to
/// make way for it there. It can go to its own goal, though, once it does not have to keep off the first one's way.
TEST_F(MovePlanTest, WhoIsAskedInVainStillGoesToItsOwnGoal) {
  draw({"...",  //
        "...",  //
        ".. ",  //
        " . "});
  const Berth second = graph->at(1, 1);
  const Berth goal = graph->at(2, 1);
  const Berth third = graph->at(1, 2);
  graph->one_way(graph->at(1, 0), second);
  graph->one_way(graph->at(0, 2), third);
  graph->one_way(graph->at(0, 2), graph->at(0, 1));
  graph->touch(graph->at(0, 1), second, goal);
  graph->touch(second, goal, third);
  graph->lay_beside(third, graph->at(1, 3));
  graph->touch(second, third, graph->at(1, 3));
  graph->touch(third, graph->at(1, 3), third);
  put(graph->at(0, 1), second);
  put(second, goal);
  put(third);
  plan();
  EXPECT_EQ(end_of(1), goal);
}

TEST_F(MovePlanTest, MovesToAndFroBesideOneAnotherDoNotLeadAway) {
  draw({".. ",  //
        "..."});
  const Berth here = graph->at(0, 0);
  const Berth beside = graph->at(0, 1);
  graph->lay_beside(here, beside);
  const auto move = [&](Berth from, Berth to) {
    const std::vector<BerthArc>& arcs = graph->next(from, 0);
    const auto arc = std::find_if(arcs.begin(), arcs.end(), [to](const BerthArc& each) { return each.to == to; });
    return PlannedMove{.arc = &*arc, .from = from, .step = 0, .first = {}};
  };
  std::vector<PlannedMove> moves;
  EXPECT_FALSE(leads_away(*graph, here, moves));
  moves = {move(here, beside), move(beside, here), move(here, beside)};
  EXPECT_FALSE(leads_away(*graph, here, moves));
  moves.push_back(move(beside, graph->at(1, 1)));
  EXPECT_TRUE(leads_away(*graph, here, moves));
}

TEST_F(MovePlanTest, NobodyIsReleasedToWhereAnotherComesFirst) {
  draw({".....",  //
        ".....",  //
        "....."});
  put(graph->at(1, 1), graph->at(4, 1));
  put(graph->at(2, 0), graph->at(2, 2));
  plan();
  PlanOrder order(made);
  EXPECT_EQ(order.may(0), 3U);
  EXPECT_EQ(order.may(1), 0U);  // the crossing is the other one's first
  EXPECT_TRUE(order.is_shared(0, 0));
  EXPECT_FALSE(order.is_shared(0, 2));
  order.release(0, 1);
  EXPECT_EQ(order.may(1), 2U);
}

}  // namespace
}  // namespace weft::server::test
