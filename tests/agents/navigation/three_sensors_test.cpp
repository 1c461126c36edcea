// A robot with three sensors at three rates, a method each.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "agents/navigation/multi_method_navigator.hpp"
#include "agents/navigation/navigator_of.hpp"
#include "tests/agents/methods/tiny/grid_filter.hpp"
#include "tests/agents/methods/tiny/ramp_stereo.hpp"
#include "tests/support/navigated_robot.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::LittleServer;
using test::MarksRobotConfig;
using test::MarksWorld;
using test::NavigatedRobot;

class ThreeSensors : public testing::Test {
 protected:
  static constexpr ExperienceId kRun{21};

  std::unique_ptr<Navigator> navigator() {
    std::vector<SensorNavigator> all;
    all.push_back({"marks", make_navigator(MarksMethod{}, {}, "marks")});
    all.push_back({"pair", make_navigator(tiny::RampStereo{}, {}, "pair")});
    all.push_back({"grid", make_navigator(tiny::GridFilter{}, {}, "grid")});
    return make_multi_method_navigator(std::move(all), {});
  }
  NavigatedRobot robot_at(const Pose2& start, std::uint64_t seed) {
    MarksRobotConfig config;
    config.base = {0.1, 1, 0.02, 0.02, 0.01};
    config.elapsed_s = 0.05;
    NavigatedRobot robot(world, config, start, seed, navigator());
    robot.looks = [this](Sample& sample, const Pose2& plan) {
      const std::vector<View> seen = std::exchange(sample.views, {});
      for (const View& view : seen) {
        if (sample.frame % 2 == 0) add(sample, "marks", view.data);
        if (sample.frame % 3 == 0) add(sample, "pair", tiny::StereoUp::look(*marks_of(view), plan));
        if (sample.frame % 5 == 0) add(sample, "grid", view.data);
      }
    };
    return robot;
  }
  void add(Sample& sample, const std::string& sensor, decltype(View::data) data) {
    ++images[sensor];
    sample.views.push_back({sample.frame, sample.time, sensor, sensor, std::move(data)});
  }
  static Course course() { return std::move(Course({5, 5, 0}).straight(4.0)); }

  /// Hands each place to the experience of its method.
  void take(const std::vector<Kept>& kept, const Pose2& at) {
    std::map<ExperienceId, std::vector<Kept>> by_run;
    for (const Kept& one : kept) {
      truth[one.place.id] = at;
      by_run[one.place.id.experience].push_back(one);
    }
    for (const auto& [run, places] : by_run) server.take(run, {{1}}, places.front().place.method, places);
  }
  void teach() {
    NavigatedRobot robot = robot_at(course().poses.front(), 1);
    robot.navigator().begin_teach({kRun, {{1}}, {ExperienceId{22}, ExperienceId{23}}});
    const auto step = [&] { take(robot.step(server.map(), true).kept, robot.world_from_robot()); };
    robot.hand(course().poses, step);
    take(robot.navigator().end_teach(server.map()), robot.world_from_robot());
    for (int i = 0; i < 40 && robot.navigator().is_taught(); ++i) {
      step();
      take(robot.navigator().end_teach(server.map()), robot.world_from_robot());
    }
    EXPECT_FALSE(robot.navigator().is_taught());
  }

  MarksWorld world{{}, 77};
  LittleServer server;
  std::map<PlaceId, Pose2> truth;
  std::map<std::string, int> images;
};

TEST_F(ThreeSensors, TeachAnExperienceEachJoinedToOneAnother) {
  teach();
  EXPECT_NEAR(2.0 * images["marks"], 3.0 * images["pair"], 6.0);
  EXPECT_NEAR(2.0 * images["marks"], 5.0 * images["grid"], 10.0);
  std::map<std::string, int> places;
  for (const auto& [id, place] : server.window().places) ++places[place.method];
  EXPECT_GT(places["marks"], 15);
  EXPECT_GT(places["ramp-stereo"], 15);
  EXPECT_GT(places["grid-filter"], 15);
  std::map<std::string, int> changes;
  for (const auto& [id, edge] : server.window().edges) {
    if (edge.method.find('+') == std::string::npos) continue;
    ++changes[edge.method];
    const Pose2 truly = truth.at(id.a).inverse() * truth.at(id.b);
    EXPECT_LT((truly.inverse() * planar(edge.a_from_b)).translation().norm(), 0.06) << edge.method;
  }
  EXPECT_EQ(changes.size(), 2U) << "each of the others with the first";
}

TEST_F(ThreeSensors, DriveAWayThatGoesThroughTheMapsOfAllThree) {
  teach();
  NavigatedRobot robot = robot_at(truth.at({kRun, 0}) * Pose2{0.0, 0.04, 0.05}, 2);
  robot.navigator().seek(std::nullopt);
  for (int i = 0; i < 60; ++i) robot.step(server.map());
  ASSERT_TRUE(robot.navigator().estimate());
  const std::vector<std::string> drives = robot.navigator().drives();
  EXPECT_EQ(drives.size(), 6U) << "three methods, and the changes between two each";
  const PlaceId goal = server.snapshot().experience(ExperienceId{23})->places.back().id;
  const Route route =
      server.route(robot.navigator().estimate()->place, goal, std::set<std::string>(drives.begin(), drives.end()));
  robot.navigator().follow(route);
  Navigated now;
  for (int i = 0; i < 4000 && now.following != Following::arrived && now.following != Following::failed; ++i)
    now = robot.step(server.map());
  EXPECT_EQ(now.following, Following::arrived) << now.reason;
  EXPECT_LT(test::distance(robot.world_from_robot(), truth.at(goal)), 0.1);
  EXPECT_EQ(robot.navigator().method(), "grid-filter") << "it arrives by the map that the goal is in";
}

}  // namespace
}  // namespace weft::agents
