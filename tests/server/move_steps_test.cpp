#include "server/traffic/plan/move_steps.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <limits>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "tests/server/drawn_graph.hpp"

namespace weft::server::test {
namespace {

constexpr std::uint64_t kAtOnce = std::numeric_limits<std::uint64_t>::max();

/// Draws aisles, one dead end among them, so narrow that robots have to make way for one another.
const std::vector<std::string> kAisles = {"............",  //
                                          ".  .    .  .",  //
                                          ".  .    .  .",  //
                                          "............",  //
                                          ".    .     .",  //
                                          "............",  //
                                          "      .     ",  //
                                          "      .     "};
constexpr std::size_t kRobots = 14;

/// Holds what is looked up and found on one graph, so that each plan begins with nothing known.
struct Drawn {
  Drawn() {
    std::vector<Berth> berths(graph.size());
    for (Berth berth = 0; berth < berths.size(); ++berth) berths[berth] = berth;
    std::erase_if(berths, [this](Berth berth) { return !graph.is_cut(berth); });
    Random random(101);
    const auto draw = [&] {
      const std::size_t index = random.below(berths.size());
      const Berth berth = berths[index];
      berths.erase(berths.begin() + static_cast<std::ptrdiff_t>(index));
      return berth;
    };
    for (std::size_t i = 0; i < kRobots; ++i) {
      PlanRobot robot;
      robot.at = draw();
      robot.waits_s = 100.0 - static_cast<double>(i);
      pockets.look(robot.at, 0);
      robots.push_back(robot);
    }
    // Some have nothing to do, and make way.
    for (std::size_t i = 0; i + 4 < kRobots; ++i) {
      const Berth goal = draw();
      robots[i].goal = &distances.emplace_back(graph, goal, 0, nothing);
      robots[i].pocket = pockets.look(goal, 0);
    }
  }

  DrawnGraph graph{kAisles};
  Pockets pockets{graph};
  Lanes lanes{graph};
  const std::vector<Berth> nothing;
  std::deque<Distances> distances;
  std::vector<PlanRobot> robots;
};

struct Made {
  MovePlan plan;
  std::size_t pieces = 0;
};

Made made_in_pieces_of(std::uint64_t most, Drawn& drawn) {
  MoveSteps steps(drawn.graph, drawn.pockets, drawn.lanes, drawn.robots, {.steps = 30, .handling = 2});
  Made made;
  for (bool is_complete = false; !is_complete; ++made.pieces) is_complete = steps.work(most);
  made.plan = steps.take();
  return made;
}

void expect_same(const MovePlan& plan, const MovePlan& other) {
  EXPECT_EQ(plan.kept_by, other.kept_by);
  EXPECT_EQ(plan.pushes, other.pushes);
  EXPECT_EQ(plan.asked_several, other.asked_several);
  ASSERT_EQ(plan.moves.size(), other.moves.size());
  for (std::size_t robot = 0; robot < plan.moves.size(); ++robot) {
    ASSERT_EQ(plan.moves[robot].size(), other.moves[robot].size()) << "robot " << robot;
    for (std::size_t i = 0; i < plan.moves[robot].size(); ++i) {
      const PlannedMove& a = plan.moves[robot][i];
      const PlannedMove& b = other.moves[robot][i];
      EXPECT_EQ(a.from, b.from) << "robot " << robot << ", move " << i;
      EXPECT_EQ(a.arc->to, b.arc->to) << "robot " << robot << ", move " << i;
      EXPECT_EQ(a.step, b.step) << "robot " << robot << ", move " << i;
      ASSERT_EQ(a.first.size(), b.first.size());
      for (std::size_t k = 0; k < a.first.size(); ++k) {
        EXPECT_EQ(a.first[k].robot, b.first[k].robot);
        EXPECT_EQ(a.first[k].moves, b.first[k].moves);
      }
    }
  }
}

TEST(MoveSteps, HoweverAPlanIsDividedItIsTheSame) {
  Drawn drawn;
  const MovePlan whole =
      plan_moves(drawn.graph, drawn.pockets, drawn.lanes, drawn.robots, {.steps = 30, .handling = 2});
  ASSERT_GT(whole.pushes, 0U) << "robots make way in it";
  for (const std::uint64_t most : {std::uint64_t{1}, std::uint64_t{7}, kAtOnce}) {
    SCOPED_TRACE("pieces of " + std::to_string(most));
    Drawn again;
    expect_same(whole, made_in_pieces_of(most, again).plan);
  }
}

TEST(MoveSteps, APieceIsNoLargerThanWhatOneRobotDecidesBeyondWhatIsAsked) {
  Drawn drawn;
  MoveSteps steps(drawn.graph, drawn.pockets, drawn.lanes, drawn.robots, {.steps = 30, .handling = 2});
  // Each of those that are asked searches from each of its berths, with another one away each time.
  constexpr std::uint64_t kOfOneRobot = 40 * kRobots;
  std::uint64_t pieces = 0;
  for (bool is_complete = false; !is_complete; ++pieces) {
    const std::uint64_t before = steps.done();
    is_complete = steps.work(10);
    EXPECT_LE(steps.done() - before, 10 + kOfOneRobot);
    EXPECT_TRUE(is_complete || steps.done() - before >= 10);
  }
  EXPECT_GT(pieces, 30U);
}

TEST(MoveSteps, APlanOfNobodyIsComplete) {
  Drawn drawn;
  drawn.robots.clear();
  EXPECT_TRUE(made_in_pieces_of(kAtOnce, drawn).plan.moves.empty());
}

}  // namespace
}  // namespace weft::server::test
