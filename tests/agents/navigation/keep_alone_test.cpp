#include "tests/agents/navigation/marks_fleet.hpp"

/// Tests a place that is kept for its name alone, by a robot that is not being taught.
namespace weft::agents {
namespace {

using test::Course;
using test::NavigatedRobot;

class KeepAlone : public MarksFleet {
 protected:
  static constexpr ExperienceId alone{13};
  static constexpr RobotId who{{2}};
  void SetUp() override { teach(first, Course({5, 5, 0}).straight(6.0).poses); }

  OrRefusal<Kept> kept_at(const Pose2& from_place, std::uint64_t seed) {
    const PlaceId near{first, 12};
    NavigatedRobot robot = localised_at(truth.at(near) * from_place, near, seed);
    OrRefusal<Kept> kept = robot.navigator().keep_alone({alone, who}, server.map());
    EXPECT_TRUE(robot.navigator().estimate());
    if (kept) truth[kept->place.id] = robot.world_from_robot();
    return kept;
  }
};

TEST_F(KeepAlone, IsDrivenToAndDrivenOnFrom) {
  int made = 0;
  for (const Pose2& from_place : {Pose2{0.1, 0.0, 0.0}, Pose2{-0.07, 0.05, 0.06}, Pose2{0.05, -0.08, -0.06}}) {
    const auto seed = static_cast<std::uint64_t>(++made);
    const OrRefusal<Kept> kept = kept_at(from_place, 10 + seed);
    ASSERT_TRUE(kept) << kept.error().reason;
    const ExperienceId own{alone.value + seed};
    Kept mine = *kept;
    mine.place.id.experience = own;
    for (Edge& edge : mine.edges) edge.id.b.experience = own;
    truth[mine.place.id] = truth.at(kept->place.id);
    server.take(own, who, "marks", {mine});

    NavigatedRobot there = localised_at(truth.at({first, 0}), {first, 0}, 20 + seed);
    const Driven driven = drive(there, server.route({first, 0}, mine.place.id, "marks"));
    EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
    EXPECT_LT(test::distance(there.world_from_robot(), truth.at(mine.place.id)), 0.04);
    EXPECT_LT(test::turned(there.world_from_robot(), truth.at(mine.place.id)), 0.05);

    const Driven on = drive(there, server.route(mine.place.id, last_of(first), "marks"));
    EXPECT_EQ(on.last.following, Following::arrived) << on.last.reason;
  }
}

TEST_F(KeepAlone, ARobotThatStandsAcrossTheWayIsRefused) {
  const OrRefusal<Kept> kept = kept_at({0.0, 0.0, 0.6}, 31);
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().reason, "stands_across");
}

TEST_F(KeepAlone, ALostOrTaughtRobotIsRefused) {
  NavigatedRobot nowhere = robot_at({5, 5, 0}, 41);
  nowhere.step(server.map());
  EXPECT_EQ(nowhere.navigator().keep_alone({alone, who}, server.map()).error().reason, "not_localised");
  nowhere.navigator().begin_teach({second, who});
  nowhere.step(server.map(), true);
  EXPECT_EQ(nowhere.navigator().keep_alone({alone, who}, server.map()).error().reason, "being_taught");
}

TEST_F(KeepAlone, PlacesOnTheirWayToTheServerAreNotJoinedTo) {
  NavigatedRobot robot = robot_at({5, 9, 0}, 51);
  robot.teach(server, second, Course({5, 9, 0}).straight(1.0).poses, truth, false);
  const test::LittleServer empty;
  robot.step(empty.map());
  const OrRefusal<Kept> kept = robot.navigator().keep_alone({alone, who}, empty.map());
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().reason, "nothing_joined");
}

}  // namespace
}  // namespace weft::agents
