#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "agents/navigation/navigator_of.hpp"
#include "tests/agents/methods/tiny/along_path.hpp"
#include "tests/agents/methods/tiny/grid_filter.hpp"
#include "tests/agents/methods/tiny/ramp_stereo.hpp"
#include "tests/agents/methods/tiny/roamer.hpp"
#include "tests/agents/methods/tiny/two_place_pnp.hpp"
#include "tests/support/marks.hpp"
#include "tests/support/navigated_robot.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::LittleServer;
using test::MarksRobotConfig;
using test::MarksWorld;
using test::NavigatedRobot;
using test::Truth;

/// Bounds what can be asked of a method's accuracy in this world.
struct Bounds {
  double fix_m = 0.03;
  double fix_rad = 0.03;
  double odometry_m = 0.02;
  double lateral_m = 0.05;
  double goal_m = 0.05;
  double goal_rad = 0.05;
  double stitch_m = 0.04;
};

template <class M>
struct Asked {
  static Bounds bounds() { return {}; }
};
template <>
struct Asked<tiny::GridFilter> {
  static Bounds bounds() {
    Bounds bounds;
    bounds.fix_m = 0.05;
    bounds.lateral_m = 0.07;
    bounds.goal_m = 0.07;
    return bounds;
  }
};
template <>
struct Asked<tiny::Roamer> {
  /// Allows for corners that it cuts: it keeps to the places no more than it is held for.
  static Bounds bounds() {
    Bounds bounds = Asked<tiny::GridFilter>::bounds();
    bounds.lateral_m = 0.2;
    return bounds;
  }
};
template <>
struct Asked<tiny::AlongThePath> {
  /// Bounds only what lies along the path and the heading: what lies across the path is not known.
  static Bounds bounds() { return {0.15, 0.2, 0.02, 0.12, 0.15, 0.12, 0.2}; }
};

/// Sets the bounds of the stereo method, which has the pixels of a small image, and the plan of a slope.
template <>
struct Asked<tiny::RampStereo> {
  static Bounds bounds() {
    Bounds bounds;
    bounds.fix_m = 0.05;
    bounds.odometry_m = 0.03;
    bounds.lateral_m = 0.07;
    bounds.goal_m = 0.07;
    bounds.stitch_m = 0.06;
    return bounds;
  }
};

/// Gives each view of marks as a stereo pair on the ramp has it.
void look_in_stereo(Sample& sample, const Pose2& world_from_robot) {
  for (View& view : sample.views) view.data = tiny::StereoUp::look(*marks_of(view), world_from_robot);
}

template <class M>
class EveryMethod : public testing::Test {
 protected:
  static constexpr ExperienceId first{11};
  static constexpr ExperienceId second{12};

  NavigatedRobot robot_at(const Pose2& start, std::uint64_t seed) {
    MarksRobotConfig config;
    config.base = {0.1, 1, 0.02, 0.02, 0.01};
    NavigatedRobot robot(world, config, start, seed, make_navigator(M{}, NavigationConfig{}));
    if constexpr (std::is_same_v<M, tiny::RampStereo>) robot.looks = look_in_stereo;
    return robot;
  }
  Course course() const { return std::move(Course({5, 5, 0}).straight(3.0).turn(1.0, M_PI / 2).straight(2.5)); }
  void teach_first() {
    NavigatedRobot robot = robot_at(course().poses.front(), 1);
    robot.teach(server, first, course().poses, truth);
  }
  PlaceId last_of(ExperienceId experience) const {
    return server.snapshot().experience(experience)->places.back().id;
  }
  static void run(NavigatedRobot& robot, const LittleServer& server, int samples) {
    for (int i = 0; i < samples; ++i) robot.step(server.map());
  }
  void expect_estimate(NavigatedRobot& robot) {
    const auto estimate = robot.navigator().estimate();
    ASSERT_TRUE(estimate);
    const Pose2 believed = truth.at(estimate->place) * laid_out(estimate->place_from_robot);
    EXPECT_LT(test::distance(believed, robot.world_from_robot()), Asked<M>::bounds().fix_m);
    EXPECT_LT(test::turned(believed, robot.world_from_robot()), Asked<M>::bounds().fix_rad);
  }

  struct Driven {
    Following following = Following::none;
    std::string_view reason;
    double worst_lateral_m = 0.0;
    int fixes = 0;
  };
  /// Follows until it arrives or stands for long; lateral error against the taught places, after `settled_m`.
  Driven drive(NavigatedRobot& robot, const Route& route, double settled_m = 1.0) {
    robot.navigator().follow(route);
    std::vector<Pose2> taught;
    for (const PlaceId& id : route.places) taught.push_back(truth.at(id));
    const Pose2 start = robot.world_from_robot();
    Driven driven;
    int standing = 0;
    for (int i = 0; i < 3000 && standing < 30; ++i) {
      const Navigated navigated = robot.step(server.map());
      driven.following = navigated.following;
      driven.reason = navigated.reason;
      driven.fixes += navigated.fix ? 1 : 0;
      standing = navigated.following == Following::driving ? 0 : standing + 1;
      if (test::distance(start, robot.world_from_robot()) < settled_m) continue;
      if (navigated.following != Following::driving) continue;
      driven.worst_lateral_m = std::max(driven.worst_lateral_m, test::distance_to(taught, robot.world_from_robot()));
    }
    return driven;
  }

  MarksWorld world{{}, 77};
  LittleServer server;
  Truth truth;
};

using Methods = testing::Types<MarksMethod, tiny::GridFilter, tiny::TwoPlacePnp, tiny::AlongThePath, tiny::RampStereo,
                               tiny::Roamer>;
TYPED_TEST_SUITE(EveryMethod, Methods);

TYPED_TEST(EveryMethod, TeachesAChainOfPlaces) {
  this->teach_first();
  const Experience* const experience = this->server.snapshot().experience(this->first);
  ASSERT_NE(experience, nullptr);
  EXPECT_GT(experience->places.size(), 30U);
  EXPECT_LT(experience->places.size(), 60U);
  EXPECT_LT(test::distance(this->truth.at(experience->places.back().id), this->course().poses.back()), 0.05);
  for (const Edge& edge : experience->chain) {
    const Pose2 truly = this->truth.at(edge.id.a).inverse() * this->truth.at(edge.id.b);
    EXPECT_LT(test::distance(truly, laid_out(edge.a_from_b)), Asked<TypeParam>::bounds().odometry_m);
    EXPECT_EQ(edge.origin, Origin::odometry);
    EXPECT_EQ(edge.drivable, drives_both_ways<TypeParam>() ? Drivable::both : Drivable::a_to_b);
  }
}

TYPED_TEST(EveryMethod, FindsItselfAroundASeed) {
  this->teach_first();
  NavigatedRobot robot = this->robot_at(this->truth.at({this->first, 9}) * Pose2{0.05, 0.08, 0.12}, 2);
  robot.navigator().seek(PlaceId{this->first, 5});
  this->run(robot, this->server, 10);
  this->expect_estimate(robot);
}

TYPED_TEST(EveryMethod, FindsItselfWithoutASeed) {
  this->teach_first();
  NavigatedRobot robot = this->robot_at(this->truth.at({this->first, 25}) * Pose2{-0.05, 0.05, -0.12}, 3);
  robot.navigator().seek(std::nullopt);
  this->run(robot, this->server, 25);
  this->expect_estimate(robot);
}

TYPED_TEST(EveryMethod, FollowsWhatWasTaught) {
  this->teach_first();
  NavigatedRobot robot = this->robot_at(this->truth.at({this->first, 1}) * Pose2{0.0, 0.06, 0.1}, 4);
  robot.navigator().seek(PlaceId{this->first, 1});
  this->run(robot, this->server, 10);
  const PlaceId goal = this->last_of(this->first);
  const auto driven = this->drive(robot, this->server.route({this->first, 1}, goal, std::string(TypeParam::name)));
  EXPECT_EQ(driven.following, Following::arrived) << driven.reason;
  EXPECT_LT(driven.worst_lateral_m, Asked<TypeParam>::bounds().lateral_m);
  EXPECT_LT(test::distance(robot.world_from_robot(), this->truth.at(goal)), Asked<TypeParam>::bounds().goal_m);
  EXPECT_LT(test::turned(robot.world_from_robot(), this->truth.at(goal)), Asked<TypeParam>::bounds().goal_rad);
  EXPECT_GT(driven.fixes, 20);
}

TYPED_TEST(EveryMethod, StitchesASecondExperienceAndDrivesAcross) {
  this->teach_first();
  // Beside the first straight, then straight on where the first turned.
  const Course along = std::move(Course({6, 5, 0}).straight(5.0));
  NavigatedRobot taught = this->robot_at(along.beside(0.08).front(), 5);
  taught.navigator().seek(PlaceId{this->first, 5});
  this->run(taught, this->server, 10);
  taught.teach(this->server, this->second, along.beside(0.08), this->truth);

  int stitches = 0;
  for (const Edge& edge : this->server.snapshot().experience(this->second)->stitches) {
    ++stitches;
    EXPECT_EQ(edge.id.a.experience, this->first);
    const Pose2 truly = this->truth.at(edge.id.a).inverse() * this->truth.at(edge.id.b);
    EXPECT_LT(test::distance(truly, laid_out(edge.a_from_b)), Asked<TypeParam>::bounds().stitch_m);
    // Where the roads part, places are still joined for a while, but not to be driven across.
    EXPECT_EQ(edge.drivable == Drivable::both, can_cross(StitchConfig{}, edge.a_from_b));
  }
  EXPECT_GT(stitches, 5);

  NavigatedRobot robot = this->robot_at(this->truth.at({this->first, 0}), 6);
  robot.navigator().seek(PlaceId{this->first, 0});
  this->run(robot, this->server, 10);
  const PlaceId goal = this->last_of(this->second);
  const Route route = this->server.route({this->first, 0}, goal, std::string(TypeParam::name));
  EXPECT_EQ(route.places.front().experience, this->first);
  EXPECT_EQ(route.places.back().experience, this->second);
  const auto driven = this->drive(robot, route);
  EXPECT_EQ(driven.following, Following::arrived) << driven.reason;
  EXPECT_LT(test::distance(robot.world_from_robot(), this->truth.at(goal)), Asked<TypeParam>::bounds().goal_m);
}

TYPED_TEST(EveryMethod, SaysLostWhereItHasNotBeen) {
  this->teach_first();
  NavigatedRobot robot = this->robot_at(this->truth.at({this->first, 3}), 7);
  robot.navigator().seek(PlaceId{this->first, 3});
  this->run(robot, this->server, 10);
  ASSERT_TRUE(robot.navigator().estimate());
  // Someone pushes it off the map.
  Navigated last;
  robot.hand(Course(robot.world_from_robot()).turn(0.8, -M_PI / 2).straight(3.5).poses,
             [&] { last = robot.step(this->server.map(), true); });
  EXPECT_TRUE(last.lost);
  robot.navigator().follow(
      this->server.route({this->first, 3}, this->last_of(this->first), std::string(TypeParam::name)));
  const Pose2 before = robot.world_from_robot();
  for (int i = 0; i < 30; ++i) last = robot.step(this->server.map());
  EXPECT_EQ(last.following, Following::stopped);
  EXPECT_TRUE(last.lost);
  EXPECT_LT(test::distance(before, robot.world_from_robot()), 0.01);
}

using OnARamp = EveryMethod<tiny::RampStereo>;

TEST_F(OnARamp, PlacesClimb) {
  teach_first();
  Relation first_from_here = Metric3{};
  double steepest_rad = 0.0;
  for (const Edge& edge : server.snapshot().experience(first)->chain) {
    first_from_here = compose(first_from_here, edge.a_from_b);
    const Eigen::Vector3d ahead = std::get<Metric3>(first_from_here).a_from_b.rotation * Eigen::Vector3d::UnitX();
    steepest_rad = std::max(steepest_rad, std::asin(ahead.z()));
  }
  const double rises_m = tiny::Ramp::z(course().poses.back().x) - tiny::Ramp::z(course().poses.front().x);
  EXPECT_GT(rises_m, 0.25);
  EXPECT_NEAR(std::get<Metric3>(first_from_here).a_from_b.translation.z(), rises_m, 0.06);
  EXPECT_NEAR(steepest_rad, std::atan(tiny::Ramp::slope(7.5)), 0.04);
}

TEST_F(OnARamp, AViewFromAboveItIsRefusedByItsHeightAlone) {
  teach_first();
  NavigatedRobot robot = robot_at(truth.at({first, 9}), 2);
  robot.navigator().seek(PlaceId{first, 9});
  run(robot, server, 10);
  ASSERT_TRUE(robot.navigator().estimate());
  robot.refusals.clear();
  robot.looks = [](Sample& sample, const Pose2& plan) {  // as if the robot stood on a box: all is nearer by 0.5 m
    for (View& view : sample.views) {
      std::vector<std::pair<std::uint64_t, Eigen::Vector3d>> marks;
      const Pose3 robot_from_world = tiny::Ramp::world_from_robot(plan).inverse();
      const Marks seen = *marks_of(view);
      for (const Marks::Sighting& one : seen.sightings) {
        const Eigen::Vector2d on_plan = plan * one.robot_from_mark.translation();
        marks.emplace_back(one.mark, robot_from_world * tiny::Ramp::world_from_mark(one.mark, on_plan) -
                                         Eigen::Vector3d(0.0, 0.0, 0.5));
      }
      view.data =
          StereoPair{tiny::StereoUp::draw(marks, 0.0), tiny::StereoUp::draw(marks, tiny::StereoUp::baseline_m)};
    }
  };
  run(robot, server, 12);
  EXPECT_GT(robot.refusals["disagrees_with_prediction"], 0);
}

}  // namespace
}  // namespace weft::agents
