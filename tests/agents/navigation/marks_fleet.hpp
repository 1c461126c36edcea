#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "agents/navigation/navigator_of.hpp"
#include "tests/support/marks.hpp"
#include "tests/support/navigated_robot.hpp"

namespace weft::agents {

/// Arranges robots with one method, `marks` unless a test says otherwise, on one floor, one little server, and what
/// is true.
class MarksFleet : public testing::Test {
 protected:
  static constexpr ExperienceId first{11};
  static constexpr ExperienceId second{12};

  virtual std::unique_ptr<Navigator> navigator() const { return make_navigator(MarksMethod{}, navigation); }
  virtual std::string method() const { return "marks"; }

  void make_world(const test::MarksWorldConfig& config) { world = test::MarksWorld(config, 77); }

  test::NavigatedRobot robot_at(const Pose2& start, std::uint64_t seed) {
    test::MarksRobotConfig config;
    config.base = {0.1, 1, 0.02, 0.02, 0.01};
    return test::NavigatedRobot(world, config, start, seed, navigator());
  }
  void teach(ExperienceId experience, const std::vector<Pose2>& path, std::uint64_t seed = 1) {
    test::NavigatedRobot robot = robot_at(path.front(), seed);
    robot.teach(server, experience, path, truth);
  }
  test::NavigatedRobot localised_at(const Pose2& start, const PlaceId& place, std::uint64_t seed) {
    test::NavigatedRobot robot = robot_at(start, seed);
    robot.navigator().seek(place);
    run(robot, 10);
    EXPECT_TRUE(robot.navigator().estimate());
    return robot;
  }
  Navigated run(test::NavigatedRobot& robot, int samples) {
    Navigated last;
    for (int i = 0; i < samples; ++i) last = robot.step(server.map());
    return last;
  }
  PlaceId last_of(ExperienceId experience) const {
    return server.snapshot().experience(experience)->places.back().id;
  }
  Route route_to_last(const PlaceId& from) const { return server.route(from, last_of(from.experience), method()); }
  double believed_error_m(test::NavigatedRobot& robot) const {
    const auto estimate = robot.navigator().estimate();
    if (!estimate) return 1e9;
    return test::distance(truth.at(estimate->place) * planar(estimate->place_from_robot), robot.world_from_robot());
  }
  std::vector<Pose2> true_path(const Route& route) const {
    std::vector<Pose2> path;
    for (const PlaceId& id : route.places) path.push_back(truth.at(id));
    return path;
  }

  struct Driven {
    Navigated last;
    double worst_lateral_m = 0.0;
    double longest_blind_m = 0.0;
    double worst_turn_rad_s = 0.0;
    int samples = 0;
  };
  /// Drives until the robot has not been driving for a while. `each` may intervene.
  Driven drive(test::NavigatedRobot& robot, const Route& route, double settled_m = 1.0,
               const std::function<void(const Navigated&)>& each = nullptr) {
    robot.navigator().follow(route);
    const std::vector<Pose2> path = true_path(route);
    const Pose2 start = robot.world_from_robot();
    Driven driven;
    int standing = 0;
    for (; driven.samples < 4000 && standing < 30; ++driven.samples) {
      driven.last = robot.step(server.map());
      if (each) each(driven.last);
      standing = driven.last.following == Following::driving ? 0 : standing + 1;
      if (const auto estimate = robot.navigator().estimate()) {
        driven.longest_blind_m = std::max(driven.longest_blind_m, estimate->blind_m);
      }
      driven.worst_turn_rad_s = std::max(driven.worst_turn_rad_s, std::abs(driven.last.command.angular_rad_s));
      if (driven.last.following != Following::driving || path.size() < 2) continue;
      if (test::distance(start, robot.world_from_robot()) < settled_m) continue;
      driven.worst_lateral_m = std::max(driven.worst_lateral_m, test::distance_to(path, robot.world_from_robot()));
    }
    return driven;
  }

  NavigationConfig navigation;
  test::MarksWorld world{{}, 77};
  test::LittleServer server;
  test::Truth truth;
};

}  // namespace weft::agents
