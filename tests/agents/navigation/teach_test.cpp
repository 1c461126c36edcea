#include "tests/agents/navigation/marks_fleet.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::MarksWorldConfig;
using test::NavigatedRobot;

using Teach = MarksFleet;

TEST_F(Teach, KeepsPlacesByDistanceAndByTurn) {
  teach(first, Course({5, 5, 0}).straight(3.0).turn(0.5, M_PI / 2).poses);
  const Experience& experience = *server.snapshot().experience(first);
  ASSERT_GE(experience.chain.size(), 20U);
  for (std::size_t i = 0; i + 1 < experience.chain.size(); ++i) {
    const Relation& hop = experience.chain[i].a_from_b;
    EXPECT_TRUE(distance_m(hop) >= navigation.teach.spacing_m - 1e-9 ||
                std::abs(heading_rad(hop)) >= navigation.teach.spacing_rad - 1e-9);
    EXPECT_LT(distance_m(hop), navigation.teach.spacing_m + 0.08);
    EXPECT_LT(std::abs(heading_rad(hop)), navigation.teach.spacing_rad + 0.12);
  }
  EXPECT_LT(test::distance(truth.at(last_of(first)), {5 + 3.0 + 0.5, 5.5, 0}), 0.06);
}

TEST_F(Teach, AnEdgeOverABlindStretchSaysSo) {
  MarksWorldConfig config;
  config.blank = {{7.0, 5.0, 0.35}};
  make_world(config);
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  int blind = 0;
  for (const Edge& edge : server.snapshot().experience(first)->chain) {
    const bool crosses = truth.at(edge.id.b).x > 6.6 && truth.at(edge.id.a).x < 7.4;
    if (edge.origin == Origin::blind) {
      ++blind;
      EXPECT_TRUE(crosses) << truth.at(edge.id.a).x;
      EXPECT_GT(distance_m(edge.a_from_b), 0.6);  // nothing was kept where nothing was seen
    }
  }
  EXPECT_EQ(blind, 1);
}

TEST_F(Teach, APlaceIsKeptAtOnceWhenAskedFor) {
  NavigatedRobot robot = robot_at({5, 5, 0}, 1);
  run(robot, 2);
  robot.navigator().begin_teach({first, RobotId{{1}}});
  EXPECT_EQ(robot.step(server.map(), true).kept.size(), 1U);
  EXPECT_TRUE(robot.step(server.map(), true).kept.empty());
  robot.navigator().keep_place();
  const auto kept = robot.step(server.map(), true).kept;
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].place.id.index, 1U);
  EXPECT_EQ(kept[0].edges.size(), 1U);
}

TEST_F(Teach, TheEndIsKeptUnlessItIsAPlaceAlready) {
  NavigatedRobot robot = robot_at({5, 5, 0}, 1);
  robot.navigator().begin_teach({first, RobotId{{1}}});
  robot.step(server.map(), true);
  EXPECT_TRUE(robot.navigator().end_teach(server.map()).empty());
  EXPECT_TRUE(robot.navigator().end_teach(server.map()).empty());
}

TEST_F(Teach, TheEndWaitsForAView) {
  NavigatedRobot robot = robot_at({5, 5, 0}, 1);
  robot.navigator().begin_teach({first, RobotId{{1}}});
  robot.hand(Course({5, 5, 0}).straight(0.3).poses, [&] { robot.step(server.map(), true); });
  robot.blind = true;
  robot.step(server.map(), true);
  EXPECT_TRUE(robot.navigator().end_teach(server.map()).empty());
  EXPECT_TRUE(robot.navigator().is_taught()) << "images are rarer than samples: the last place is not to be lost";
  robot.blind = false;
  robot.step(server.map(), true);
  const std::vector<Kept> last = robot.navigator().end_teach(server.map());
  ASSERT_EQ(last.size(), 1U);
  EXPECT_GT(last[0].place.id.index, 0U);
  EXPECT_FALSE(robot.navigator().is_taught());
}

TEST_F(Teach, TheEndWaitsForAViewThatShowsSomething) {
  NavigatedRobot robot = robot_at({5, 5, 0}, 1);
  robot.navigator().begin_teach({first, RobotId{{1}}});
  robot.hand(Course({5, 5, 0}).straight(0.3).poses, [&] { robot.step(server.map(), true); });
  robot.dark = true;
  robot.step(server.map(), true);
  EXPECT_TRUE(robot.navigator().end_teach(server.map()).empty());
  EXPECT_TRUE(robot.navigator().is_taught()) << "the next view may show more";
  robot.dark = false;
  robot.step(server.map(), true);
  EXPECT_EQ(robot.navigator().end_teach(server.map()).size(), 1U);
  EXPECT_FALSE(robot.navigator().is_taught());
}

TEST_F(Teach, ItCanBeLeftWithoutAnEnd) {
  NavigatedRobot robot = robot_at({5, 5, 0}, 1);
  robot.navigator().begin_teach({first, RobotId{{1}}});
  EXPECT_TRUE(robot.navigator().is_taught());
  EXPECT_TRUE(robot.navigator().leave_teach().empty());
  EXPECT_FALSE(robot.navigator().is_taught());
  EXPECT_TRUE(robot.step(server.map(), true).kept.empty());
}

TEST_F(Teach, AfterwardsTheRobotKnowsWhereItIsBeforeTheServerDoes) {
  NavigatedRobot robot = robot_at({5, 5, 0}, 1);
  robot.teach(server, first, Course({5, 5, 0}).straight(3.0).poses, truth, false);
  ASSERT_TRUE(robot.navigator().estimate());
  EXPECT_EQ(robot.navigator().estimate()->place, last_of(first));
  const test::LittleServer empty;
  for (int i = 0; i < 30; ++i) robot.step(empty.map());
  EXPECT_LT(believed_error_m(robot), 0.03);
  EXPECT_LT(robot.navigator().estimate()->blind_m, 0.05);
}

TEST_F(Teach, ALoopIsClosedByTwoStitchesThatAgree) {
  teach(first, Course({5, 5, 0}).straight(5.0).turn(1.2, M_PI).straight(5.0).turn(1.2, M_PI).straight(2.0).poses);
  const Experience& experience = *server.snapshot().experience(first);
  int closures = 0;
  for (const Edge& edge : experience.stitches) {
    ++closures;
    EXPECT_EQ(edge.id.b.experience, first);
    EXPECT_GT(edge.id.b.index, edge.id.a.index + 20);
    const Pose2 truly = truth.at(edge.id.a).inverse() * truth.at(edge.id.b);
    EXPECT_LT(test::distance(truly, planar(edge.a_from_b)), 0.04);
    EXPECT_LT(test::turned(truly, planar(edge.a_from_b)), 0.04);
  }
  EXPECT_GT(closures, 5);
  EXPECT_LT(closures, 25);
}

TEST_F(Teach, ARunThatEndsBesideAnotherOneIsNoDeadEnd) {
  teach(first, Course({5, 5, 0}).straight(8.0).poses);
  NavigatedRobot robot = localised_at({6, 5.1, 0}, {first, 5}, 2);
  robot.teach(server, second, Course({6, 5.1, 0}).straight(2.5).poses, truth);
  bool leads_on = false;
  for (const Edge& edge : server.snapshot().experience(second)->stitches) {
    leads_on = leads_on || (edge.id.b == last_of(second) && edge.drivable == Drivable::both);
  }
  EXPECT_TRUE(leads_on);
}

TEST_F(Teach, WrongViewsMakeNoWrongStitches) {
  MarksWorldConfig config;
  config.wrong_share = 0.25;
  config.alias_share = 0.1;
  make_world(config);
  teach(first, Course({5, 5, 0}).straight(8.0).poses);
  NavigatedRobot robot = localised_at({6, 5.1, 0}, {first, 5}, 2);
  robot.teach(server, second, Course({6, 5.1, 0}).straight(4.0).turn(1.5, M_PI).straight(4.0).poses, truth);
  int stitches = 0;
  for (const Edge& edge : server.snapshot().experience(second)->stitches) {
    ++stitches;
    const Pose2 truly = truth.at(edge.id.a).inverse() * truth.at(edge.id.b);
    EXPECT_LT(test::distance(truly, planar(edge.a_from_b)), 0.06);
    EXPECT_LT(test::turned(truly, planar(edge.a_from_b)), 0.05);
  }
  EXPECT_GT(stitches, 8);
}

TEST_F(Teach, APlaceIsNotKeptFromAViewThatDoesNotFollowTheOneBefore) {
  NavigatedRobot robot = robot_at({5, 5, 0}, 1);
  robot.navigator().begin_teach({first, RobotId{{1}}});
  std::vector<Kept> kept;
  int sample = 0;
  robot.hand(Course({5, 5, 0}).straight(10.0).poses, [&] {
    robot.elsewhere = ++sample % 5 == 0 ? std::optional(Pose2{15, 15, 1}) : std::nullopt;
    for (Kept& one : robot.step(server.map(), true).kept) kept.push_back(std::move(one));
  });
  EXPECT_GE(kept.size(), 25U);
  const MarksMethod marks;
  const auto last_looks_like = [&](std::size_t i) {
    return marks.relate(marks.decode(kept[i - 1].content).value(), marks.decode(kept[i].content).value(),
                        std::nullopt);
  };
  for (std::size_t i = 1; i < kept.size(); ++i)
    EXPECT_TRUE(last_looks_like(i)) << "place " << i - 1 << " or " << i << " shows something else";
}

TEST_F(Teach, TheEndIsNotKeptFromAViewThatDoesNotFollowTheOneBefore) {
  NavigatedRobot robot = robot_at({5, 5, 0}, 1);
  robot.navigator().begin_teach({first, RobotId{{1}}});
  robot.hand(Course({5, 5, 0}).straight(0.3).poses, [&] { robot.step(server.map(), true); });
  robot.elsewhere = Pose2{15, 15, 1};
  robot.step(server.map(), true);
  EXPECT_TRUE(robot.navigator().end_teach(server.map()).empty());
  EXPECT_TRUE(robot.navigator().is_taught());
  robot.elsewhere.reset();
  for (int i = 0; i < 2; ++i) robot.step(server.map(), true);  // the first one does not follow the wrong one
  EXPECT_EQ(robot.navigator().end_teach(server.map()).size(), 1U);
}

TEST_F(Teach, TheSeedIsLookedForWhileTeachingGoesOn) {
  teach(first, Course({5, 5, 0}).straight(8.0).poses);
  for (const bool seeded : {true, false}) {
    const ExperienceId experience{seeded ? 20U : 21U};
    NavigatedRobot robot = robot_at({6, 5.1, 0}, 2);
    robot.navigator().seek(seeded ? std::optional(PlaceId{first, 4}) : std::nullopt);
    robot.teach(server, experience, Course({6, 5.1, 0}).straight(4.0).poses, truth);  // at once
    const Experience& taught = *server.snapshot().experience(experience);
    EXPECT_GT(taught.stitches.size(), 8U) << seeded;
    for (const Edge& edge : taught.stitches) {
      const Pose2 truly = truth.at(edge.id.a).inverse() * truth.at(edge.id.b);
      EXPECT_LT(test::distance(truly, planar(edge.a_from_b)), 0.04);
    }
  }
}

TEST_F(Teach, ARobotThatKnowsNothingLooksForWhatItCanBeJoinedTo) {
  teach(first, Course({5, 5, 0}).straight(8.0).poses);
  // Its own run, which it meets first wherever it looks, is nothing to be joined to.
  for (const ExperienceId experience : {ExperienceId{1}, ExperienceId{21}}) {
    NavigatedRobot robot = robot_at({3, 5.1, 0}, 2);
    robot.teach(server, experience, Course({3, 5.1, 0}).straight(7.0).poses, truth);
    const Experience& taught = *server.snapshot().experience(experience);
    EXPECT_GT(taught.stitches.size(), 8U) << to_string(experience);
  }
}

TEST_F(Teach, ARoadMetAgainIsStitchedAgain) {
  teach(first, Course({5, 5, 0}).straight(12.0).poses);
  // Along it, off to the side for a while, and back on it.
  const double side = std::acos(1.0 - 1.0 / 2.0);  // arcs of 1 m radius that together lead 1 m aside
  NavigatedRobot robot = localised_at({6, 5.0, 0}, {first, 5}, 2);
  robot.teach(server, second,
              Course({6, 5, 0})
                  .straight(1.0)
                  .turn(1.0, side)
                  .turn(1.0, -side)
                  .straight(2.0)
                  .turn(1.0, -side)
                  .turn(1.0, side)
                  .straight(2.5)
                  .poses,
              truth);
  int early = 0;
  int late = 0;
  for (const Edge& edge : server.snapshot().experience(second)->stitches) {
    const Pose2 truly = truth.at(edge.id.a).inverse() * truth.at(edge.id.b);
    EXPECT_LT(test::distance(truly, planar(edge.a_from_b)), 0.05);
    if (truth.at(edge.id.b).x < 7.5) ++early;
    if (truth.at(edge.id.b).x > 12.0) ++late;
  }
  EXPECT_GT(early, 3);
  EXPECT_GT(late, 3);
}

}  // namespace
}  // namespace weft::agents
