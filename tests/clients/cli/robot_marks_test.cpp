#include "clients/cli/robot_marks.hpp"

#include <gtest/gtest.h>

#include "core/network/change.hpp"
#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {
namespace {

constexpr ExperienceId kFirst{0xA1};

RobotId robot_id(std::uint8_t number) {
  RobotId id;
  id.bytes.fill(number);
  return id;
}

struct RobotMarks : testing::Test {
  RobotMarks() {
    Snapshot snapshot;
    for (const Batch& batch : two_loops(kFirst, {0xB2}, {}, {})) snapshot = with(snapshot, batch);
    layout = lay_out(make_window(snapshot, WindowDefinition{}));
    row.description.name = "r1";
    row.description.header.sender = robot_id(1);
    row.is_heard = true;
    row.state.localised = true;
    row.state.place = {kFirst, 4};
    row.state.place_from_robot = Metric2{{0.2, 0.1, 0.5}, Eigen::Matrix3d::Identity()};
    goal.id.bytes.fill(7);
    goal.robot = robot_id(1);
    goal.state = GoalState::executing;
    route.goal = goal.id;
    route.robot = robot_id(1);
    for (std::uint32_t i = 4; i < 20; ++i) route.places.push_back({kFirst, i});
    route.released = 9;
  }

  RobotsOnMap marks() const { return robots_on_map(layout, {row}, {goal}, {route}); }
  RobotMark mark() const { return marks().drawn.at(0); }

  Layout layout;
  msg::RobotRow row;
  Goal goal;
  Route route;
};

TEST_F(RobotMarks, ARobotStandsByItsPlaceWithItsHeading) {
  const RobotMark drawn = mark();
  EXPECT_EQ(drawn.words, "r1, idle");
  EXPECT_EQ(drawn.look, RobotMark::Look::heard);
  const Pose2& place = layout.drawing_from_place.at({kFirst, 4});
  const Pose2 expected = place * Pose2{0.2, 0.1, 0.5};
  EXPECT_NEAR(drawn.drawing_from_robot->x, expected.x, 1e-9);
  EXPECT_NEAR(drawn.drawing_from_robot->y, expected.y, 1e-9);
  EXPECT_NEAR(drawn.drawing_from_robot->heading, expected.heading, 1e-9);
}

TEST_F(RobotMarks, WhatItHoldsIsThePartOfItsRouteThatTheServerNames) {
  row.occupies = to_string(PlaceId{kFirst, 5}) + " to " + to_string(PlaceId{kFirst, 9});
  const RobotMark drawn = mark();
  ASSERT_EQ(drawn.held.size(), 5U);
  EXPECT_EQ(drawn.held.front(), (PlaceId{kFirst, 5}));
  EXPECT_EQ(drawn.held.back(), (PlaceId{kFirst, 9}));
  EXPECT_TRUE(drawn.is_held_whole);
  ASSERT_EQ(drawn.ahead.size(), 7U);
  EXPECT_EQ(drawn.ahead.front(), (PlaceId{kFirst, 13}));
  EXPECT_EQ(drawn.ahead.back(), (PlaceId{kFirst, 19}));
}

TEST_F(RobotMarks, OneThatStandsHoldsOnePlace) {
  row.occupies = to_string(PlaceId{kFirst, 4});
  EXPECT_EQ(mark().held, (std::vector<PlaceId>{{kFirst, 4}}));
  EXPECT_TRUE(mark().is_held_whole);
}

TEST_F(RobotMarks, OfARouteThatIsNotToldOnlyTheEndsOfWhatIsHeldAreKnown) {
  row.occupies = to_string(PlaceId{kFirst, 30}) + " to " + to_string(PlaceId{{0xB2}, 2});
  EXPECT_EQ(mark().held, (std::vector<PlaceId>{{kFirst, 30}, {{0xB2}, 2}}));
  EXPECT_FALSE(mark().is_held_whole);
}

TEST_F(RobotMarks, TheRouteOfAGoalThatEndedIsNotAhead) {
  goal.state = GoalState::succeeded;
  EXPECT_TRUE(mark().ahead.empty());
}

TEST_F(RobotMarks, WhatTheServerTellsInOtherWordsIsLeftOut) {
  row.occupies = "somewhere to nowhere";
  EXPECT_TRUE(mark().held.empty());
}

TEST_F(RobotMarks, LostAndSilentOnesLookSo) {
  row.state.localised = false;
  row.state.mode = msg::RobotMode::lost;
  EXPECT_EQ(mark().look, RobotMark::Look::lost);
  EXPECT_EQ(mark().words, "r1, lost");
  row.is_heard = false;
  row.silent_s = 42.3;
  EXPECT_EQ(mark().look, RobotMark::Look::silent);
  EXPECT_EQ(mark().words, "r1, silent for 42 s");
}

TEST_F(RobotMarks, WhoCannotBeDrawnIsNamedWithTheReason) {
  row.state.place = {{0xC3}, 1};
  ASSERT_EQ(marks().not_drawn.size(), 1U);
  EXPECT_EQ(marks().not_drawn[0].why, "its place is not in this picture");
  EXPECT_TRUE(marks().drawn.empty());
  row.state.place = {};
  row.state.localised = false;
  EXPECT_EQ(marks().not_drawn[0].why, "it does not know where it is");
  row.is_heard = false;
  row.occupies = to_string(PlaceId{kFirst, 4});
  EXPECT_EQ(marks().not_drawn.size(), 1U);
  ASSERT_EQ(marks().drawn.size(), 1U);  // what it holds is drawn all the same
  EXPECT_FALSE(marks().drawn[0].drawing_from_robot.has_value());
}

}  // namespace
}  // namespace weft::cli::test
