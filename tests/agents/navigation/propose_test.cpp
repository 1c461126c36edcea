#include "agents/methods/recognition/index.hpp"
#include "core/network/search.hpp"
#include "tests/agents/navigation/marks_fleet.hpp"

/// Tests a robot that does not know where it is: it asks which places look like what it sees, and looks there first.
namespace weft::agents {
namespace {

using test::Course;
using test::NavigatedRobot;

class Propose : public MarksFleet {
 protected:
  Propose() { navigation.locate.seek_tries = 1; }

  /// Returns an index of all that is taught, as whoever has the contents makes it.
  RecognitionIndex index_of_all() const {
    RecognitionIndex index;
    const MarksMethod method;
    for (const auto& [id, place] : server.window().places) {
      if (const auto signature = method.sign(*method.decode(*server.find(place.content.hash))))
        index.put(id, *signature);
    }
    return index;
  }
  /// Steps until the robot knows where it is; returns how many steps that took, at most 400.
  int until_found(NavigatedRobot& robot, const RecognitionIndex* index) {
    int samples = 0;
    for (; samples < 400 && !robot.navigator().estimate(); ++samples) {
      robot.step(server.map());
      const Question* const open = robot.navigator().question();
      if (open == nullptr || index == nullptr) continue;
      robot.navigator().propose(open->number,
                                likeliest(*index, server.snapshot(), open->seen, {.after = open->after}));
    }
    return samples;
  }
};

TEST_F(Propose, FindsItselfAmongManyPlacesByAsking) {
  teach(first, Course({5, 5, 0}).straight(22.0).turn(1.5, M_PI).straight(22.0).poses);
  ASSERT_GT(server.window().places.size(), 200U);
  const RecognitionIndex index = index_of_all();
  for (const Pose2& start : {Pose2{25, 5.05, 0.1}, Pose2{12, 7.95, M_PI}, Pose2{18, 5, -0.1}}) {
    NavigatedRobot asking = robot_at(start, 3);
    asking.navigator().seek(std::nullopt);
    EXPECT_LT(until_found(asking, &index), 30);
    EXPECT_LT(believed_error_m(asking), 0.05);
  }
}

TEST_F(Propose, TheQuestionStaysUntilItIsAnswered) {
  teach(first, Course({5, 5, 0}).straight(3.0).poses);
  NavigatedRobot robot = robot_at({30, 30, 0}, 2);
  EXPECT_EQ(robot.navigator().question(), nullptr);
  robot.navigator().seek(std::nullopt);
  run(robot, 2);
  const Question* const open = robot.navigator().question();
  ASSERT_NE(open, nullptr);
  const std::uint64_t number = open->number;
  EXPECT_EQ(open->content_format, MarksMethod::content_format);
  EXPECT_EQ(open->seen.size(), 32U);
  EXPECT_EQ(open->after, 0U);
  run(robot, 20);
  ASSERT_NE(robot.navigator().question(), nullptr);
  EXPECT_EQ(robot.navigator().question()->number, number);
  robot.navigator().propose(number, {});
  run(robot, 20);
  EXPECT_EQ(robot.navigator().question(), nullptr);
}

TEST_F(Propose, InVainItAsksForThePlacesBehindThose) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  NavigatedRobot robot = robot_at({30, 30, 0}, 2);
  robot.navigator().seek(std::nullopt);
  run(robot, 1);
  const Question asked = *robot.navigator().question();
  robot.navigator().propose(asked.number, {{first, 3}, {first, 9}, {first, 15}});
  run(robot, 2);
  EXPECT_EQ(robot.navigator().question(), nullptr);
  run(robot, 3);
  ASSERT_NE(robot.navigator().question(), nullptr);
  const Question again = *robot.navigator().question();
  EXPECT_NE(again.number, asked.number);
  EXPECT_EQ(again.after, 3U);
  EXPECT_EQ(again.seen, asked.seen);
}

TEST_F(Propose, MovedItAsksAnew) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  NavigatedRobot robot = robot_at({20, 20, 0}, 2);
  robot.navigator().seek(std::nullopt);
  run(robot, 1);
  const Question asked = *robot.navigator().question();
  robot.navigator().propose(asked.number, {{first, 3}});
  robot.hand(Course({20, 20, 0}).straight(0.6).poses, [&] { robot.step(server.map(), true); });
  ASSERT_NE(robot.navigator().question(), nullptr);
  EXPECT_GT(robot.navigator().question()->number, asked.number);
  EXPECT_EQ(robot.navigator().question()->after, 0U);
  EXPECT_NE(robot.navigator().question()->seen, asked.seen);
}

TEST_F(Propose, AnAnswerToAnEarlierQuestionIsLetGo) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  NavigatedRobot robot = robot_at({30, 30, 0}, 2);
  robot.navigator().seek(std::nullopt);
  run(robot, 1);
  const std::uint64_t number = robot.navigator().question()->number;
  robot.navigator().propose(number + 7, {{first, 3}});
  run(robot, 1);
  ASSERT_NE(robot.navigator().question(), nullptr);
  EXPECT_EQ(robot.navigator().question()->number, number);
}

TEST_F(Propose, ARobotWithASeedAsksNothing) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  NavigatedRobot robot = robot_at({30, 30, 0}, 2);
  robot.navigator().seek(PlaceId{first, 2});
  for (int i = 0; i < 60; ++i) {
    run(robot, 1);
    EXPECT_EQ(robot.navigator().question(), nullptr);
  }
}

TEST_F(Propose, FoundItAsksNothing) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  NavigatedRobot robot = robot_at({6, 5, 0}, 2);
  robot.navigator().seek(std::nullopt);
  EXPECT_LT(until_found(robot, nullptr), 400);
  EXPECT_EQ(robot.navigator().question(), nullptr);
  EXPECT_EQ(robot.navigator().suspected(), std::nullopt);
}

// Contents come over time; those that have not come are not taken for tried.
TEST_F(Propose, ProposedPlacesAreTriedWhenTheirContentsCome) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  for (const auto& [id, place] : server.window().places) server.missing.insert(place.content.hash);
  NavigatedRobot robot = robot_at({6, 5, 0}, 2);
  robot.navigator().seek(std::nullopt);
  run(robot, 1);
  robot.navigator().propose(robot.navigator().question()->number, {{first, 18}, {first, 5}, {first, 6}});
  run(robot, 30);
  EXPECT_FALSE(robot.navigator().estimate());
  EXPECT_EQ(robot.navigator().question(), nullptr);
  server.missing.clear();
  EXPECT_LT(until_found(robot, nullptr), 8);
  EXPECT_LT(believed_error_m(robot), 0.05);
}

// The window of a robot that looks at proposed places has nothing around them at first.
TEST_F(Propose, ASuspectedPlaceDoesNotConfirmItselfWhileItsNeighboursAreOnTheirWay) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  NavigatedRobot robot = robot_at({6, 5, 0}, 2);
  robot.navigator().seek(std::nullopt);
  const Window alone =
      make_window(server.snapshot(), {.centre = PlaceId{first, 5}, .hops = 0, .cap = 1, .route = {}});
  const Window around =
      make_window(server.snapshot(), {.centre = PlaceId{first, 5}, .hops = 3, .cap = 50, .route = {}});
  robot.step({alone, server});
  ASSERT_NE(robot.navigator().question(), nullptr);
  robot.navigator().propose(robot.navigator().question()->number, {{first, 5}});
  for (int i = 0; i < 20; ++i) robot.step({alone, server});
  EXPECT_EQ(robot.navigator().suspected(), (PlaceId{first, 5}));
  EXPECT_FALSE(robot.navigator().estimate());
  for (int i = 0; i < 6; ++i) robot.step({around, server});
  EXPECT_TRUE(robot.navigator().estimate());
}

TEST_F(Propose, LostItLooksAroundWhereItWasFirst) {
  teach(first, Course({5, 5, 0}).straight(8.0).poses);
  test::MarksWorldConfig config;
  config.blank = {{9.0, 5.0, 1.6}};
  make_world(config);
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  EXPECT_TRUE(drive(robot, route_to_last({first, 0})).last.lost);
  make_world({});
  EXPECT_EQ(robot.navigator().question(), nullptr);
  const Driven driven = drive(robot, route_to_last({first, 0}), 1.0, [&](const Navigated& navigated) {
    if (navigated.lost) {
      EXPECT_EQ(robot.navigator().question(), nullptr);
    }
  });
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
}

}  // namespace
}  // namespace weft::agents
