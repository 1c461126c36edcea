#include "server/traffic/plan/drive_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/server/headed_graph.hpp"

namespace weft::server::test {
namespace {

/// Draws a small block in the west, a lane, and a street that leads south from where they meet.
const std::vector<std::string> kBlockAndLane = {"..     ",  //
                                                ".......",  //
                                                ".      ",  //
                                                "..     "};

struct DriveOutTest : testing::Test {
  HeadedGraph graph{kBlockAndLane};
  std::vector<Berth> closed;

  WayOut way(Berth from, const std::vector<Berth>& out) {
    return {.from = from,
            .methods = 0,
            .is_closed = [this](const BerthArc& arc) { return std::ranges::count(closed, arc.to) > 0; },
            .is_out = [out](Berth berth) { return std::ranges::count(out, berth) > 0; }};
  }
  /// Follows the drives out, each found from where the one before ends.
  std::vector<Berth> followed(Berth from, const std::vector<Berth>& out) {
    std::vector<Berth> berths;
    for (const BerthArc* arc = drive_out(graph, way(from, out)); arc != nullptr && berths.size() < 20;) {
      berths.push_back(arc->to);
      arc = std::ranges::count(out, arc->to) > 0 ? nullptr : drive_out(graph, way(arc->to, out));
    }
    return berths;
  }
};

TEST_F(DriveOutTest, ItLeadsToTheNearestBerthThatIsOut) {
  const Berth near = graph.at(0, 2, Heading::south);
  const Berth far = graph.at(1, 3, Heading::east);
  EXPECT_EQ(followed(graph.at(1, 0, Heading::west), {far, near}),
            (std::vector<Berth>{graph.at(0, 0, Heading::west), graph.at(0, 1, Heading::south), near}));
}

TEST_F(DriveOutTest, WhoFollowsItDoesNotDriveInACircle) {
  const Berth out = graph.at(1, 3, Heading::east);
  const std::vector<Berth> berths = followed(graph.at(1, 1, Heading::north), {out});
  ASSERT_FALSE(berths.empty());
  EXPECT_EQ(berths.back(), out);
  for (const Berth berth : berths) EXPECT_EQ(std::ranges::count(berths, berth), 1) << berth;
}

TEST_F(DriveOutTest, ItDoesNotLeadWhereNobodyDrives) {
  closed = {graph.at(0, 2, Heading::south)};
  EXPECT_EQ(drive_out(graph, way(graph.at(1, 0, Heading::west), {graph.at(1, 3, Heading::east)})), nullptr);
}

TEST_F(DriveOutTest, ThereIsNoneWhereNothingIsOut) {
  EXPECT_EQ(drive_out(graph, way(graph.at(1, 0, Heading::west), {})), nullptr);
}

}  // namespace
}  // namespace weft::server::test
