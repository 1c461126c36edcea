// Robots teach a part each by one method, one with both joins the parts, and one that was taught nothing drives from
// the first to the last: by one method, then by the other, without standing in between.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "tests/agents/agent/process/simulated_robot.hpp"

namespace weft::agents::test {
namespace {

const std::string kFolder = std::string(WEFT_SITES) + "/two-cameras/";
const std::string kHall = kFolder + "hall.toml";

std::vector<SitePoint> line_of(const std::string& name) {
  std::ifstream in(kFolder + name);
  std::vector<SitePoint> line;
  for (SitePoint point; in >> point.x >> point.y;) line.push_back(point);
  return line;
}

/// Says who teaches the way's two parts.
struct Teachers {
  std::string first, first_by, second, second_by;
};

class TwoCameras : public testing::TestWithParam<Teachers> {};

TEST_P(TwoCameras, HandOverWithoutStopping) {
  const Teachers& teachers = GetParam();
  weft::test::LittleServer map;
  std::map<PlaceId, Pose2> truth;
  {
    SimulatedRobot first(kHall, teachers.first, {teachers.first_by}, map);
    first.be_taught(10, line_of("first.line"), truth);
    SimulatedRobot second(kHall, teachers.second, {teachers.second_by}, map);
    second.be_taught(20, line_of("second.line"), truth);
    SimulatedRobot both(kHall, "r3", {"floor", "bearing"}, map);
    both.look_around();
    both.be_taught(30, line_of("crossing.line"), truth);
  }
  int changes = 0;
  for (const auto& [id, edge] : map.window().edges) {
    if (edge.method != "bearing+floor") continue;
    ++changes;
    const Pose2 truly = truth.at(id.a).inverse() * truth.at(id.b);
    EXPECT_LT((truly.inverse() * planar(edge.a_from_b)).translation().norm(), 0.02);
    EXPECT_EQ(map.window().place(id.a)->method, "floor");
    EXPECT_EQ(map.window().place(id.b)->method, "bearing");
  }
  EXPECT_GE(changes, 10);

  SimulatedRobot stranger(kHall, "r4", {"floor", "bearing"}, map);
  stranger.look_around();
  ASSERT_TRUE(stranger.navigator().estimate());
  const PlaceId from = stranger.navigator().estimate()->place;
  EXPECT_EQ(from.experience, ExperienceId{10});
  const PlaceId goal = std::prev(truth.lower_bound({ExperienceId{21}, 0}))->first;
  const std::vector<std::string> drives = stranger.navigator().drives();
  const Route route = map.route(from, goal, std::set<std::string>(drives.begin(), drives.end()));
  stranger.navigator().follow(route);
  Navigated now;
  std::vector<std::string> by;
  double slowest_m_s = 10.0;
  double begun_s = 0.0;
  Pose2 last = stranger.pose();
  for (int i = 0; i < 3000 && now.following != Following::arrived && now.following != Following::failed; ++i) {
    now = stranger.step();
    const std::string method(stranger.navigator().method());
    if (by.empty() || by.back() != method) by.push_back(method);
    // Between the first and the last metre, over half a second.
    begun_s += stranger.elapsed_s();
    if (begun_s < 0.5) continue;
    const Pose2 here = stranger.pose();
    const bool is_between = here.x > 2.7 && here.y < 7.0;
    if (is_between) slowest_m_s = std::min(slowest_m_s, (last.inverse() * here).translation().norm() / begun_s);
    last = here;
    begun_s = 0.0;
  }
  EXPECT_EQ(by, (std::vector<std::string>{teachers.first_by, teachers.second_by}));
  EXPECT_GT(slowest_m_s, 0.15) << "a bend may slow it where the ways meet; it does not stop for the change";
  EXPECT_EQ(now.following, Following::arrived) << now.reason;
  const Pose2 goal_from_robot = truth.at(goal).inverse() * stranger.pose();
  EXPECT_LT(goal_from_robot.translation().norm(), 0.15);
}

INSTANTIATE_TEST_SUITE_P(, TwoCameras,
                         testing::Values(Teachers{"r1", "floor", "r2", "bearing"},
                                         Teachers{"r4", "bearing", "r3", "floor"}),
                         [](const auto& each) { return each.param.first_by + "First"; });

}  // namespace
}  // namespace weft::agents::test
