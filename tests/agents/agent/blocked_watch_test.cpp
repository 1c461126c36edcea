#include "agents/agent/blocked_watch.hpp"

#include <gtest/gtest.h>

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

Estimate at(double x_m, std::uint32_t place = 3) {
  Estimate estimate;
  estimate.place = {ExperienceId{1}, place};
  Metric2 pose;
  pose.a_from_b.x = x_m;
  estimate.place_from_robot = pose;
  return estimate;
}

struct Blocked : testing::Test {
  /// Lets so many half seconds pass in which the robot is asked that, and is there.
  void pass(int halves, const Twist& asked, const std::optional<Estimate>& estimate) {
    for (int i = 0; i < halves; ++i) watch.take(asked, false, estimate, now += 500ms);
  }
  SteadyTime now{std::chrono::seconds(100)};
  BlockedWatch watch;
  Twist drive{.linear_m_s = 0.3, .angular_rad_s = 0.0};
};

TEST_F(Blocked, RobotThatIsAskedToDriveAndStandsIsBlockedAfterTwoSeconds) {
  pass(4, drive, at(0.0));
  EXPECT_FALSE(watch.is_blocked());
  pass(1, drive, at(0.01));
  EXPECT_TRUE(watch.is_blocked()) << "a centimetre is noise";
}

TEST_F(Blocked, RobotThatMovesIsNot) {
  for (int i = 0; i < 20; ++i) pass(1, drive, at(0.04 * i));
  EXPECT_FALSE(watch.is_blocked());
  pass(5, drive, at(0.8));
  EXPECT_TRUE(watch.is_blocked());
  pass(1, drive, at(0.0, 4));
  EXPECT_FALSE(watch.is_blocked()) << "it is at another place";
}

TEST_F(Blocked, RobotThatIsToStandIsNot) {
  pass(20, Twist{}, at(0.0));
  EXPECT_FALSE(watch.is_blocked());
  pass(4, drive, at(0.0));
  EXPECT_FALSE(watch.is_blocked()) << "it has been asked for less than two seconds";
}

TEST_F(Blocked, RobotWhoseMethodSeesSomethingInItsWayIs) {
  for (int i = 0; i < 4; ++i) watch.take(Twist{}, true, at(0.0), now += 500ms);
  EXPECT_FALSE(watch.is_blocked());
  watch.take(Twist{}, true, at(0.0), now += 500ms);
  EXPECT_TRUE(watch.is_blocked());
  watch.take(Twist{}, false, at(0.0), now += 500ms);
  EXPECT_FALSE(watch.is_blocked()) << "it went away";
}

TEST_F(Blocked, RobotThatDoesNotKnowWhereItIsCannotTell) {
  pass(20, drive, std::nullopt);
  EXPECT_FALSE(watch.is_blocked());
}

}  // namespace
}  // namespace weft::agents::test
