#include "core/network/removal.hpp"
#include "tests/agents/navigation/marks_fleet.hpp"

/// Tests edits of the map under a robot that knows where it is.
namespace weft::agents {
namespace {

using test::Course;
using test::NavigatedRobot;

class MapChanged : public MarksFleet {
 protected:
  void SetUp() override {
    teach(first, Course({5, 5, 0}).straight(6.0).poses);
    NavigatedRobot other = localised_at({5, 5.1, 0}, {first, 0}, 3);
    other.teach(server, second, Course({5, 5.1, 0}).straight(6.0).poses, truth);
  }
  Window window() const { return make_window(server.snapshot(), {}); }
  Window window_without(const Removal& what) const { return make_window(without(server.snapshot(), what), {}); }
};

TEST_F(MapChanged, WhatIsBelievedMovesToTheNearestPlaceThatStays) {
  const PlaceId at{first, 10};
  NavigatedRobot robot = localised_at(truth.at(at), at, 11);
  ASSERT_TRUE(robot.navigator().estimate());
  const Window after = window_without({{{first, 8, 12}}, {}});
  EXPECT_TRUE(robot.navigator().map_changed(window(), after));
  const Estimate moved = *robot.navigator().estimate();
  EXPECT_NE(after.place(moved.place), nullptr);
  const Pose2 believed = truth.at(moved.place) * planar(moved.place_from_robot);
  EXPECT_LT(test::distance(believed, robot.world_from_robot()), 0.1);
}

TEST_F(MapChanged, WhatComesBackIsStoodOnAgain) {
  const PlaceId at{first, 15};
  NavigatedRobot robot = localised_at(truth.at(at), at, 15);
  const Window after = window_without({{{first, 1, 29}, {second, 1, 29}}, {}});
  ASSERT_TRUE(robot.navigator().map_changed(window(), after));
  ASSERT_GT(distance_m(robot.navigator().estimate()->place_from_robot), 2.0);
  for (int i = 0; i < 30; ++i) robot.step(server.map(), false);
  const Estimate again = *robot.navigator().estimate();
  EXPECT_LT(distance_m(again.place_from_robot), 0.3) << to_string(again.place);
  const Pose2 believed = truth.at(again.place) * planar(again.place_from_robot);
  EXPECT_LT(test::distance(believed, robot.world_from_robot()), 0.05);
}

TEST_F(MapChanged, APoseDoesNotMoveOverPlacesOfAnotherMethod) {
  const PlaceId at{first, 10};
  NavigatedRobot robot = localised_at(truth.at(at), at, 16);
  ASSERT_EQ(robot.navigator().estimate()->place, at);
  // By a place that another camera has seen, the other end of the hall is two hops away.
  const auto with_another = [&](Window window) {
    Place other = *window.place({first, 20});
    other.id = {ExperienceId{99}, 0};
    other.method = "along";
    window.places.emplace(other.id, other);
    for (const PlaceId& end : {at, PlaceId{second, 29}}) {
      Edge edge;
      edge.id = {end, other.id};
      edge.a_from_b = AlongPath{0.1, 1e-4, 0.0, 1e-4};
      edge.origin = Origin::stitch;
      window.edges.insert_or_assign(edge.id, edge);
    }
    index_edges(window);
    return window;
  };
  const Removal around{{{first, 7, 13}, {second, 0, 28}}, {}};
  EXPECT_TRUE(robot.navigator().map_changed(with_another(window()), with_another(window_without(around))));
  const Estimate moved = *robot.navigator().estimate();
  EXPECT_TRUE(std::holds_alternative<Metric2>(moved.place_from_robot));
  EXPECT_EQ(moved.place.experience, first);
  EXPECT_LT(test::distance(truth.at(moved.place) * planar(moved.place_from_robot), robot.world_from_robot()), 0.1);
}

TEST_F(MapChanged, NothingMovesWhenItsPlaceStays) {
  const PlaceId at{first, 10};
  NavigatedRobot robot = localised_at(truth.at(at), at, 12);
  const PlaceId before = robot.navigator().estimate()->place;
  const Removal elsewhere{{{first, 20, 22}}, {}};
  EXPECT_TRUE(robot.navigator().map_changed(window(), window_without(elsewhere)));
  EXPECT_EQ(robot.navigator().estimate()->place, before);
}

TEST_F(MapChanged, WithNothingLeftItSaysSoAndForgetsOnlyWhenItIsTold) {
  const PlaceId at{first, 10};
  NavigatedRobot robot = localised_at(truth.at(at), at, 13);
  EXPECT_FALSE(robot.navigator().map_changed(window(), Window{}));
  EXPECT_TRUE(robot.navigator().estimate());
  robot.navigator().forget_where();
  EXPECT_FALSE(robot.navigator().estimate());
}

TEST_F(MapChanged, RefusedPlacesAreNoneToStandOn) {
  NavigatedRobot robot = localised_at(truth.at({first, 2}), {first, 2}, 14);
  const ExperienceId third{14};
  robot.navigator().begin_teach({third, RobotId{{3}}});
  const Pose2 start = robot.world_from_robot();
  robot.hand(Course(start).straight(2.0).poses, [&] { robot.step(server.map(), true); });
  std::ignore = robot.navigator().end_teach(server.map());
  ASSERT_EQ(robot.navigator().estimate()->place.experience, third) << "it knows where it is from its own places";
  robot.navigator().forget_taught(server.map().window);
  ASSERT_TRUE(robot.navigator().estimate());
  EXPECT_NE(server.map().window.place(robot.navigator().estimate()->place), nullptr);
}

}  // namespace
}  // namespace weft::agents
