#include "tests/agents/navigation/marks_fleet.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::MarksWorldConfig;
using test::NavigatedRobot;

using Recover = MarksFleet;

TEST_F(Recover, AShortBlindStretchIsCrossedByDeadReckoning) {
  teach(first, Course({5, 5, 0}).straight(6.0).poses);
  MarksWorldConfig config;
  config.blank = {{7.5, 5.0, 0.5}};  // someone has painted the floor since
  make_world(config);
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  const Driven driven = drive(robot, route_to_last({first, 0}));
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_GT(driven.longest_blind_m, 0.9);
  EXPECT_LT(driven.longest_blind_m, navigation.follow.blind_limit_m);
  EXPECT_LT(driven.worst_lateral_m, 0.1);
  EXPECT_GT(robot.refusals["no_marks"], 5);
}

TEST_F(Recover, BlindForTooLongItIsLostAndStands) {
  teach(first, Course({5, 5, 0}).straight(8.0).poses);
  MarksWorldConfig config;
  config.blank = {{9.0, 5.0, 1.6}};
  make_world(config);
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  double last_speed_m_s = 0.0;
  const Driven driven = drive(robot, route_to_last({first, 0}), 1.0, [&](const Navigated& navigated) {
    if (navigated.command.linear_m_s > 0.0) last_speed_m_s = navigated.command.linear_m_s;
  });
  EXPECT_LT(last_speed_m_s, 0.5 * navigation.follow.speed_m_s) << "it slows down before it is lost";
  EXPECT_EQ(driven.last.following, Following::stopped);
  EXPECT_TRUE(driven.last.lost);
  EXPECT_EQ(driven.last.reason, "lost");
  EXPECT_EQ(driven.last.command, Twist{});
  // From the last fix before the blank; the base needs some way to stand.
  EXPECT_LT(robot.world_from_robot().x, 9.0 - 1.6 + navigation.follow.blind_limit_m + 0.35);
}

TEST_F(Recover, LostItFindsItselfWhenItSeesSomethingAgainAndGoesOn) {
  teach(first, Course({5, 5, 0}).straight(8.0).poses);
  MarksWorldConfig config;
  config.blank = {{9.0, 5.0, 1.6}};
  make_world(config);
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  const Route route = route_to_last({first, 0});
  EXPECT_TRUE(drive(robot, route).last.lost);
  make_world({});  // the floor is cleaned
  const Driven driven = drive(robot, route);
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_LT(believed_error_m(robot), 0.03);
}

TEST_F(Recover, WrongViewsNeverMoveTheBelief) {
  teach(first, Course({5, 5, 0}).straight(4.0).turn(1.5, M_PI).straight(4.0).poses);
  MarksWorldConfig config;
  config.wrong_share = 0.25;
  config.alias_share = 0.05;
  make_world(config);
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  double worst = 0.0;
  const Driven driven = drive(robot, route_to_last({first, 0}), 1.0, [&](const Navigated& navigated) {
    if (navigated.fix) worst = std::max(worst, believed_error_m(robot));
  });
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_LT(worst, 0.06);
}

TEST_F(Recover, AnUnseededFixNeedsASecondOneThatAgrees) {
  teach(first, Course({5, 5, 0}).straight(6.0).poses);
  NavigatedRobot robot = robot_at({8, 5.1, 0.2}, 2);
  robot.navigator().seek(std::nullopt);
  bool unconfirmed = false;
  for (int i = 0; i < 40 && !robot.navigator().estimate(); ++i) {
    const Navigated navigated = robot.step(server.map());
    for (const Refusal& refusal : navigated.refusals) unconfirmed = unconfirmed || refusal.reason == "unconfirmed";
    EXPECT_TRUE(unconfirmed || !navigated.fix);
  }
  EXPECT_TRUE(unconfirmed);
  EXPECT_LT(believed_error_m(robot), 0.03);
}

TEST_F(Recover, SeekingIsBoundedForEachSample) {
  teach(first, Course({5, 5, 0}).straight(12.0).poses);
  NavigatedRobot robot = robot_at({30, 30, 0}, 2);  // nowhere on the map
  robot.navigator().seek(std::nullopt);
  for (int i = 0; i < 40; ++i) {
    EXPECT_LE(robot.step(server.map()).refusals.size(), navigation.locate.seek_tries + 2);
  }
  EXPECT_FALSE(robot.navigator().estimate());
  EXPECT_GT(robot.refusals["few_marks"], 100);
}

TEST_F(Recover, ASeedThatTheWindowLacksIsNamed) {
  teach(first, Course({5, 5, 0}).straight(2.0).poses);
  NavigatedRobot robot = robot_at({5, 5, 0}, 2);
  robot.navigator().seek(PlaceId{second, 3});
  run(robot, 3);
  EXPECT_EQ(robot.refusals["seed_not_in_window"], 3);
}

TEST_F(Recover, ContentsThatHaveNotArrivedAreNamedAndUsedWhenTheyCome) {
  teach(first, Course({5, 5, 0}).straight(3.0).poses);
  for (const auto& [id, place] : server.window().places) server.missing.insert(place.content.hash);
  NavigatedRobot robot = robot_at({6, 5, 0}, 2);
  robot.navigator().seek(PlaceId{first, 5});
  run(robot, 4);
  EXPECT_FALSE(robot.navigator().estimate());
  EXPECT_GT(robot.refusals["content_missing"], 0);
  server.missing.clear();
  run(robot, 15);
  EXPECT_LT(believed_error_m(robot), 0.03);
}

TEST_F(Recover, DroppedFramesAreSurvived) {
  teach(first, Course({5, 5, 0}).straight(5.0).poses);
  test::MarksRobotConfig config;
  config.dropped_share = 0.3;
  NavigatedRobot robot(world, config, truth.at({first, 0}), 2, make_navigator(MarksMethod{}, navigation));
  robot.navigator().seek(PlaceId{first, 0});
  run(robot, 10);
  const Driven driven = drive(robot, route_to_last({first, 0}));
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_GT(robot.refusals["no_view"], 10);
}

}  // namespace
}  // namespace weft::agents
