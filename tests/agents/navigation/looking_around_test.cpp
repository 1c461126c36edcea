// Tests that a robot that is lost looks around, with a method that recovers.
#include "agents/navigation/recovery.hpp"
#include "tests/agents/navigation/roamer_fleet.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

using test::Course;
using test::NavigatedRobot;

class LookingAround : public RoamerFleet {
 protected:
  void SetUp() override { teach(first, Course({5, 5, 0}).straight(6.0).poses); }
  /// Returns a robot that a hand has pushed off the map.
  NavigatedRobot pushed_away() {
    NavigatedRobot robot = localised_at(truth.at({first, 3}), {first, 3}, 7);
    Navigated last;
    robot.hand(Course(robot.world_from_robot()).turn(0.8, -M_PI / 2).straight(3.5).poses, [&] {
      last = robot.step(server.map(), true);
      EXPECT_EQ(last.command, Twist{}) << "a hand drives";
    });
    EXPECT_TRUE(last.lost);
    return robot;
  }
  double turned_rad(NavigatedRobot& robot, int samples) {
    double turned = 0.0;
    const Pose2 before = robot.world_from_robot();
    for (int i = 0; i < samples; ++i) {
      const Navigated navigated = robot.step(server.map());
      EXPECT_EQ(navigated.command.linear_m_s, 0.0);
      turned += std::abs(navigated.command.angular_rad_s) * 0.1;
    }
    EXPECT_LT(test::distance(before, robot.world_from_robot()), 0.02) << "it does not leave its footprint";
    return turned;
  }
};

TEST_F(LookingAround, LostWithARouteItTurnsOnTheSpotAsTheMethodSays) {
  NavigatedRobot robot = pushed_away();
  robot.navigator().follow(route_to_last({first, 3}));
  const double turned = turned_rad(robot, 300);
  EXPECT_GT(turned, 4.0 * M_PI - 0.5);
  EXPECT_LT(turned, 4.0 * M_PI + 1.0) << "then it stands";
  ASSERT_FALSE(noted->lost.empty());
  EXPECT_GT(noted->lost.back().turned_rad, 4.0 * M_PI);
  EXPECT_GT(noted->lost.back().time, 30s);
  const Navigated navigated = run(robot, 1);
  EXPECT_TRUE(navigated.lost);
  EXPECT_EQ(navigated.reason, "lost");
}

TEST_F(LookingAround, LostWithNobodyWaitingForItItStands) {
  NavigatedRobot robot = pushed_away();
  EXPECT_EQ(turned_rad(robot, 30), 0.0);
  EXPECT_TRUE(noted->lost.empty());
}

TEST_F(LookingAround, ItsRouteStoppedItStands) {
  NavigatedRobot robot = pushed_away();
  robot.navigator().follow(route_to_last({first, 3}));
  EXPECT_GT(turned_rad(robot, 10), 0.0);
  robot.navigator().stop();
  EXPECT_EQ(turned_rad(robot, 30), 0.0);
}

TEST_F(LookingAround, AskedWhereItIsItTurnsUntilItIsFound) {
  // Turned away from all that was taught.
  NavigatedRobot robot = robot_at({5.0, 6.4, M_PI / 2}, 3);
  robot.navigator().seek(std::nullopt);
  bool turned = false;
  Navigated navigated;
  for (int i = 0; i < 300 && !robot.navigator().estimate(); ++i) {
    navigated = robot.step(server.map());
    turned = turned || navigated.command.angular_rad_s != 0.0;
    EXPECT_EQ(navigated.command.linear_m_s, 0.0);
  }
  EXPECT_TRUE(turned);
  ASSERT_TRUE(robot.navigator().estimate());
  EXPECT_LT(believed_error_m(robot), 0.1);
  EXPECT_EQ(turned_rad(robot, 20), 0.0) << "it knows where it is";
}

TEST_F(LookingAround, StoppedWhileItIsAskedItStands) {
  NavigatedRobot robot = robot_at({20.0, 20.0, 0.0}, 3);
  robot.navigator().seek(std::nullopt);
  EXPECT_GT(turned_rad(robot, 10), 0.0);
  robot.navigator().stop();
  EXPECT_EQ(turned_rad(robot, 20), 0.0);
}

using LookingAroundInVain = MarksFleet;

TEST_F(LookingAroundInVain, AMethodThatDoesNotRecoverStands) {
  teach(first, Course({5, 5, 0}).straight(6.0).poses);
  NavigatedRobot robot = robot_at({20.0, 20.0, 0.0}, 3);
  robot.navigator().seek(std::nullopt);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(robot.step(server.map()).command, Twist{});
}

}  // namespace
}  // namespace weft::agents
