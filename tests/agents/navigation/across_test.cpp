#include "agents/navigation/across.hpp"

#include "tests/agents/navigation/marks_fleet.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::NavigatedRobot;

constexpr double kQuarter = M_PI / 2.0;

Course& turn_round(Course& course) {
  return course.turn(1.0, -M_PI / 3.0).turn(1.0, 5.0 * M_PI / 3.0).turn(1.0, -M_PI / 3.0);
}

class MetAcross : public MarksFleet {
 protected:
  /// Returns stitches of a run between places whose headings differ by about that much, in the order of the run.
  std::vector<Edge> met(ExperienceId experience, double heading_rad) const {
    std::vector<Edge> found;
    for (const Edge& stitch : server.snapshot().experience(experience)->stitches) {
      const double turned = std::abs(turned_by(stitch));
      if (std::abs(turned - heading_rad) < M_PI / 4.0) found.push_back(stitch);
    }
    std::sort(found.begin(), found.end(), [](const Edge& a, const Edge& b) { return a.id.b < b.id.b; });
    return found;
  }
  void expect_right_and_not_drivable(const std::vector<Edge>& stitches) const {
    for (const Edge& stitch : stitches) {
      EXPECT_EQ(stitch.drivable, Drivable::none);
      EXPECT_EQ(stitch.origin, Origin::stitch);
      const Pose2 off = (truth.at(stitch.id.a).inverse() * truth.at(stitch.id.b)).inverse() * planar(stitch.a_from_b);
      EXPECT_LT(off.translation().norm(), 0.05);
      EXPECT_LT(std::abs(off.heading), 0.03);
    }
  }
  /// Returns the widest gap between stitches that follow one another, as the robot drove.
  double widest_gap_m(const std::vector<Edge>& stitches) const {
    double widest = 0.0;
    for (std::size_t i = 1; i < stitches.size(); ++i)
      widest = std::max(widest, test::distance(truth.at(stitches[i - 1].id.b), truth.at(stitches[i].id.b)));
    return widest;
  }

 private:
  static double turned_by(const Edge& edge) { return wrap_angle(planar(edge.a_from_b).heading); }
};

TEST_F(MetAcross, AnAisleThereAndBackIsTightAtEveryMetre) {
  Course course({5, 10, 0});
  turn_round(course.straight(10.0)).straight(10.0);
  teach(first, course.poses);
  const std::vector<Edge> back = met(first, M_PI);
  expect_right_and_not_drivable(back);
  EXPECT_LE(widest_gap_m(back), 1.0);
  EXPECT_GE(back.size(), 8U);
  EXPECT_LE(back.size(), 20U);  // of 50 places: one in 0.6 m at most
}

TEST_F(MetAcross, AnotherRobotThatComesBackIsJoinedToTheFirst) {
  teach(first, Course({5, 10, 0}).straight(10.0).poses);
  NavigatedRobot robot = localised_at({13.0, 10.0, 0.0}, {first, 40}, 2);
  Course course({13.0, 10.0, 0.0});
  turn_round(course.straight(2.0)).straight(10.0);
  robot.teach(server, second, course.poses, truth);
  const std::vector<Edge> back = met(second, M_PI);
  expect_right_and_not_drivable(back);
  EXPECT_LE(widest_gap_m(back), 1.0);
  EXPECT_GE(back.size(), 8U);
}

TEST_F(MetAcross, ACrossingIsJoined) {
  Course course({10, 10, 0});
  course.straight(6.0).turn(2.0, 3.0 * kQuarter).straight(5.0);
  teach(first, course.poses);
  const std::vector<Edge> across = met(first, kQuarter);
  EXPECT_GE(across.size(), 1U);
  EXPECT_LE(across.size(), 5U);
  expect_right_and_not_drivable(across);
}

/// Shows that a pair is joined once: two stitches of one pair are refused by the server, and the run with them.
TEST_F(MetAcross, APairOfPlacesIsJoinedOnce) {
  navigation.stitch.across_every_m = 0.01;
  navigation.stitch.reach_m = 3.0;
  navigation.stitch.most_reach_m = 3.0;
  teach(first, Course({5, 10, 0}).straight(6.0).poses);
  for (const double degrees : {50.0, 60.0, 70.0}) {
    const double heading = degrees * M_PI / 180.0;
    const ExperienceId crossing{static_cast<std::uint64_t>(degrees)};
    NavigatedRobot robot = localised_at({8.0, 10.0, 0.0}, {first, 15}, 2);
    Course course({8.0, 10.0, 0.0});
    robot.teach(server, crossing, course.turn(1.0, heading).straight(1.0).poses, truth);
    std::set<EdgeId> pairs;
    for (const Edge& stitch : server.snapshot().experience(crossing)->stitches)
      EXPECT_TRUE(pairs.insert(stitch.id).second) << to_string(stitch.id.a) << ' ' << to_string(stitch.id.b);
    EXPECT_GE(pairs.size(), 3U);
  }
}

TEST_F(MetAcross, WhereTwoLanesOnlyPassFarApartNothingIsJoined) {
  Course course({5, 10, 0});
  course.straight(8.0).turn(2.0, M_PI).straight(8.0);  // 4 m aside
  teach(first, course.poses);
  EXPECT_TRUE(met(first, M_PI).empty());
}

TEST_F(MetAcross, TurnedOffNothingIsCompared) {
  navigation.stitch.enabled = false;
  Course course({5, 10, 0});
  turn_round(course.straight(6.0)).straight(6.0);
  teach(first, course.poses);
  EXPECT_TRUE(server.snapshot().experience(first)->stitches.empty());
}

Candidate seen_at(std::uint32_t index, const Pose2& place_from_robot) {
  return {{ExperienceId{1}, index}, 1, Metric2{place_from_robot, Eigen::Matrix3d::Zero()}, 0.0};
}

TEST(Across, ChoosesTheNearestViewOfEachDirectionAndNoneOfItsOwn) {
  const Across across{StitchConfig{}};
  const Eigen::Vector2d gaze(1.0, 0.0);
  const std::vector<Candidate> around = {
      seen_at(1, {0.0, 0.0, 0.0}),       // its own direction
      seen_at(2, {2.3, 0.0, M_PI}),      // face to face: the views meet but for 0.3 m
      seen_at(3, {1.9, 0.0, M_PI}),      // 0.1 m
      seen_at(4, {0.0, 0.0, M_PI}),      // at one spot, back to back
      seen_at(5, {1.0, -0.8, kQuarter})  // from the right
  };
  const std::vector<Candidate> chosen = across.worth_comparing(around, gaze, 10.0);
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_EQ(chosen[0].place.index, 3U);
  EXPECT_EQ(chosen[1].place.index, 5U);
}

TEST(Across, ADirectionThatWasJoinedRestsForAWhileTheOthersDoNot) {
  Across across{StitchConfig{}};
  const Eigen::Vector2d gaze(1.0, 0.0);
  const std::vector<Candidate> around = {seen_at(3, {2.0, 0.0, M_PI}), seen_at(5, {1.0, -1.0, kQuarter})};
  across.joined(around[0].place_from_robot, 10.0);
  const std::vector<Candidate> soon = across.worth_comparing(around, gaze, 10.4);
  ASSERT_EQ(soon.size(), 1U);
  EXPECT_EQ(soon[0].place.index, 5U);
  EXPECT_EQ(across.worth_comparing(around, gaze, 10.7).size(), 2U);
}

}  // namespace
}  // namespace weft::agents
