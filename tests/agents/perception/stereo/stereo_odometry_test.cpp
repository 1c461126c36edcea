#include "agents/perception/stereo/stereo_odometry.hpp"

#include <gmock/gmock.h>

#include <string>

#include "tests/agents/perception/stereo/stereo_drive.hpp"

namespace weft::agents {
namespace {

using test::Drive;
using test::kBetween;

TEST(StereoOdometry, SeesADrive) {
  Drive drive(test::crate_room());
  EXPECT_EQ(drive.see_next().error().reason, "first_view");
  Pose3 start_from_robot;
  Pose2 truth;
  int keyframes = 0;
  for (int i = 0; i < 14; ++i) {
    const auto seen = drive.see_next();
    ASSERT_TRUE(seen) << seen.error().reason << " at view " << i;
    EXPECT_GE(seen->inliers, 20U);
    EXPECT_LT(seen->residual_px, 0.7);
    EXPECT_TRUE(check(Relation(seen->previous_from_current)));
    keyframes += seen->is_keyframe ? 1 : 0;
    start_from_robot = start_from_robot * seen->previous_from_current.a_from_b;
    truth = truth * drive.step;
  }
  const Vector6d off = se3_log(lift(truth).inverse() * start_from_robot);
  EXPECT_LT(off.head<3>().norm(), 0.012) << "of 0.56 m";
  EXPECT_LT(off.tail<3>().norm(), 0.008) << "of 0.28 rad";
  EXPECT_GE(keyframes, 1);
  EXPECT_LT(keyframes, 14);
}

TEST(StereoOdometry, StatesHowFarAStepIsOff) {
  double squares = 0.0;
  int steps = 0;
  for (std::uint64_t seed = 20; seed < 24; ++seed) {
    Drive drive(test::crate_room(seed));
    ASSERT_FALSE(drive.see_next());
    Pose3 start_from_robot;
    Pose2 truth;
    Relation sum = Metric3{};
    for (int i = 0; i < 6; ++i) {
      const auto seen = drive.see_next();
      ASSERT_TRUE(seen);
      start_from_robot = start_from_robot * seen->previous_from_current.a_from_b;
      truth = truth * drive.step;
      sum = compose(sum, seen->previous_from_current);
    }
    const Vector6d off = se3_log(start_from_robot.inverse() * lift(truth));
    const Matrix6d covariance = std::get<Metric3>(sum).covariance;
    squares += off.dot(covariance.inverse() * off);
    ++steps;
  }
  const double nees = squares / (6.0 * steps);  // 1 of a covariance that is right
  EXPECT_LT(nees, 12.0);
  EXPECT_GT(nees, 0.05);
}

TEST(StereoOdometry, IsBlindWhereNothingHasTexture) {
  Drive drive(test::StereoRoom(3, {{-1.0, -3.0, 0.0}, {8.0, 3.0, 3.0}, 0.0, 120.0}));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(drive.see_next().error().reason, "low_contrast");
}

TEST(StereoOdometry, IsBlindWhenALensIsCovered) {
  Drive drive(test::crate_room());
  ASSERT_FALSE(drive.see_next());
  ASSERT_TRUE(drive.see_next());
  const StereoPair pair = drive.next_pair();
  EXPECT_EQ(drive.see({test::filled(pair.left, 80), pair.right}).error().reason, "covered");
  EXPECT_EQ(drive.see({pair.left, test::filled(pair.left, 3)}).error().reason, "covered");
  EXPECT_EQ(drive.see({test::filled(pair.left, 3), test::filled(pair.left, 4)}).error().reason, "too_dark");
}

TEST(StereoOdometry, AfterABlindStretchItGoesOnFromTheKeyframe) {
  Drive drive(test::crate_room());
  ASSERT_FALSE(drive.see_next());
  ASSERT_TRUE(drive.see_next());
  Pose2 driven;
  for (int i = 0; i < 2; ++i) {
    const Image dark = test::filled(drive.next_pair().left, 3);
    ASSERT_FALSE(drive.see({dark, dark}));
    driven = driven * drive.step;
    drive.odometry.assume(drive.state, test::standing(), kBetween);
  }
  const auto seen = drive.see_next();
  ASSERT_TRUE(seen) << seen.error().reason;
  driven = driven * drive.step;
  const Vector6d off = se3_log(lift(driven).inverse() * seen->previous_from_current.a_from_b);
  EXPECT_LT(off.head<3>().norm(), 0.01) << "the step back into sight makes up for what was not seen";
}

TEST(StereoOdometry, ImagesOfTwoMomentsAreNotAPair) {
  Drive drive(test::crate_room());
  const StereoPair now = drive.next_pair();
  const test::StereoRoom room = test::crate_room();
  const Pose3 later =
      lift(Pose2{1.0, 0.0, -0.1}) *
      Pose3{Eigen::Quaterniond(Eigen::AngleAxisd(0.08, Eigen::Vector3d::UnitY())), Eigen::Vector3d::Zero()};
  const StereoPair mixed{now.left, room.pair(drive.sensor, later).right};
  EXPECT_EQ(drive.see(mixed).error().reason, "low_contrast");
}

TEST(StereoOdometry, AStepThatTheRobotCannotHaveMadeIsBlind) {
  Drive drive(test::crate_room());
  ASSERT_FALSE(drive.see_next());
  ASSERT_TRUE(drive.see_next());
  const auto seen =
      drive.see(drive.next_pair(), [](const Pose3& step, const Pose3&) { return step.translation.norm() < 0.01; });
  ASSERT_FALSE(seen);
  EXPECT_EQ(seen.error().reason, "impossible");
}

TEST(StereoOdometry, TheSameViewsGiveTheSameSteps) {
  Drive one(test::crate_room());
  Drive other(test::crate_room());
  for (int i = 0; i < 5; ++i) {
    const auto first = one.see_next();
    const auto second = other.see_next();
    ASSERT_EQ(first.has_value(), second.has_value());
    if (first) {
      EXPECT_TRUE(identical(first->previous_from_current, second->previous_from_current));
    }
  }
}

TEST(StereoOdometry, SettingsAndImagesOutOfTheirBoundsAreNamed) {
  StereoOdometryConfig config;
  config.window_px = 14;
  const auto made = StereoOdometry::make(config, test::stereo_sensor(320, 240, 208.0, 0.12));
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, testing::HasSubstr("window_px"));
  Drive drive(test::crate_room());
  const Image small{160, 120, std::make_shared<const Bytes>(160 * 120)};
  EXPECT_EQ(drive.see({small, small}).error().reason, "wrong_size");
}

}  // namespace
}  // namespace weft::agents
