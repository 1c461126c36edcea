// Robots teach a part each by one method, one with both joins the parts, and one that was taught nothing drives from
// the first to the last: by one method, then by the other, without standing in between.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "agents/navigation/method_switch.hpp"
#include "tests/agents/agent/process/method_that_looks.hpp"
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

/// Says who teaches the way's two parts, and where they look.
struct Teachers {
  std::string first;
  Gaze first_looks;
  std::string second;
  Gaze second_looks;
};

class TwoCameras : public testing::TestWithParam<Teachers> {};

TEST_P(TwoCameras, HandOverWithoutStopping) {
  const Teachers& teachers = GetParam();
  const std::string first_by = method_that_looks(teachers.first_looks);
  const std::string second_by = method_that_looks(teachers.second_looks);
  if (first_by.empty() || second_by.empty()) GTEST_SKIP() << "no method looks ahead, or none down";
  const std::string down = method_that_looks(Gaze::down);
  const std::string ahead = method_that_looks(Gaze::ahead);
  weft::test::LittleServer map;
  std::map<PlaceId, Pose2> truth;
  {
    SimulatedRobot first(kHall, teachers.first, {first_by}, map);
    first.be_taught(10, line_of("first.line"), truth);
    SimulatedRobot second(kHall, teachers.second, {second_by}, map);
    second.be_taught(20, line_of("second.line"), truth);
    SimulatedRobot both(kHall, "r3", {down, ahead}, map);
    both.look_around();
    both.be_taught(30, line_of("crossing.line"), truth);
  }
  int changes = 0;
  for (const auto& [id, edge] : map.window().edges) {
    if (edge.method != change_between(down, ahead)) continue;
    ++changes;
    const Pose2 truly = truth.at(id.a).inverse() * truth.at(id.b);
    EXPECT_LT((truly.inverse() * planar(edge.a_from_b)).translation().norm(), 0.02);
    EXPECT_EQ(map.window().place(id.a)->method, down);
    EXPECT_EQ(map.window().place(id.b)->method, ahead);
  }
  EXPECT_GE(changes, 10);

  SimulatedRobot stranger(kHall, "r4", {down, ahead}, map);
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
  EXPECT_EQ(by, (std::vector<std::string>{first_by, second_by}));
  EXPECT_GT(slowest_m_s, 0.15) << "a bend may slow it where the ways meet; it does not stop for the change";
  EXPECT_EQ(now.following, Following::arrived) << now.reason;
  const Pose2 goal_from_robot = truth.at(goal).inverse() * stranger.pose();
  EXPECT_LT(goal_from_robot.translation().norm(), 0.15);
}

INSTANTIATE_TEST_SUITE_P(, TwoCameras,
                         testing::Values(Teachers{"r1", Gaze::down, "r2", Gaze::ahead},
                                         Teachers{"r4", Gaze::ahead, "r3", Gaze::down}),
                         [](const auto& each) { return std::string(to_string(each.param.first_looks)) + "First"; });

}  // namespace
}  // namespace weft::agents::test
