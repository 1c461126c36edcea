// Views that do not fit the keyframe, and what becomes of it.
#include <gtest/gtest.h>

#include "tests/agents/perception/stereo/stereo_drive.hpp"

namespace weft::agents {
namespace {

using test::Drive;
using test::kBetween;
using test::off_m;
using test::standing;

TEST(StereoMisfits, TheKeyframeOutlivesViewsThatDoNotFitIt) {
  Drive drive(test::crate_room());
  ASSERT_FALSE(drive.see_next());
  ASSERT_TRUE(drive.see_next());
  const test::StereoRoom elsewhere = test::crate_room(77);
  for (const double heading : {0.0, 0.8}) {  // not alike, so that neither is seen from the other
    drive.next_pair();
    const auto misfit = drive.see(elsewhere.pair(drive.sensor, lift(Pose2{1.0, 0.0, heading})));
    ASSERT_FALSE(misfit);
    EXPECT_EQ(misfit.error().reason, "few_inliers");
    drive.odometry.assume(drive.state, standing(), kBetween);
  }
  const auto seen = drive.see_next();
  ASSERT_TRUE(seen) << seen.error().reason;
  EXPECT_TRUE(seen->makes_up);
  EXPECT_LT(off_m(drive.step * drive.step * drive.step, *seen), 0.01) << "nothing of what was driven is lost";
  const auto next = drive.see_next();
  ASSERT_TRUE(next);
  EXPECT_FALSE(next->makes_up);
  EXPECT_LT(off_m(drive.step, *next), 0.01);
}

TEST(StereoMisfits, WhereNothingIsSharedItIsBlindOnceAndGoesOnFromThere) {
  Drive drive(test::crate_room());
  ASSERT_FALSE(drive.see_next());
  ASSERT_TRUE(drive.see_next());
  const test::StereoRoom room = test::crate_room();
  const Pose2 turned{1.0, 0.0, 2.0};
  const auto blind = drive.see(room.pair(drive.sensor, lift(turned)));
  ASSERT_FALSE(blind) << "that turn is not seen, and not told as seen";
  drive.odometry.assume(drive.state, standing(), kBetween);
  const auto seen = drive.see(room.pair(drive.sensor, lift(turned * drive.step)));
  ASSERT_TRUE(seen) << seen.error().reason;
  EXPECT_FALSE(seen->makes_up) << "what was not seen stays unseen";
  EXPECT_LT(off_m(drive.step, *seen), 0.01);
}

TEST(StereoMisfits, AfterEnoughMisfitsTheKeyframeIsGivenUp) {
  StereoOdometryConfig config;
  config.patience = 0;
  Drive drive(test::crate_room(), config);
  ASSERT_FALSE(drive.see_next());
  ASSERT_TRUE(drive.see_next());
  ASSERT_FALSE(drive.see(test::crate_room(77).pair(drive.sensor, lift(Pose2{1.0, 0.0, 0.0}))));
  drive.odometry.assume(drive.state, standing(), kBetween);
  EXPECT_FALSE(drive.see_next()) << "the place from before is forgotten";
}

TEST(StereoMisfits, AViewThatIsMissingAfterTheFirstIsMadeUpFor) {
  Drive drive(test::crate_room());
  ASSERT_FALSE(drive.see_next());
  drive.odometry.assume(drive.state, standing(), kBetween);  // up to the first view
  drive.next_pair();
  Metric3 driven = standing();
  driven.a_from_b = lift(drive.step);
  drive.odometry.assume(drive.state, driven, kBetween);
  const auto seen = drive.see_next();
  ASSERT_TRUE(seen) << seen.error().reason;
  EXPECT_TRUE(seen->makes_up);
  EXPECT_LT(off_m(drive.step, *seen), 0.01) << "the missing step was assumed as it was";
}

TEST(StereoMisfits, LongStepsAreSeenFromTheFirstOn) {
  const Sensor sensor = test::stereo_sensor(320, 240, 208.0, 0.12);
  const test::StereoRoom room = test::crate_room();
  const StereoOdometry odometry = std::move(*StereoOdometry::make({}, sensor));
  StereoOdometry::State state;
  const Pose2 step = se2_exp({0.3, 0.0, 0.08});  // crates at 2 m move by 20 to 40 pixels
  Pose2 at{0.0, 0.0, -0.2};
  ASSERT_FALSE(odometry.observe(state, room.pair(sensor, lift(at)), kBetween, {}));
  for (int i = 0; i < 5; ++i) {
    at = at * step;
    const auto seen = odometry.observe(state, room.pair(sensor, lift(at)), kBetween, {});
    ASSERT_TRUE(seen) << seen.error().reason << " at step " << i;
    EXPECT_LT(off_m(step, *seen), 0.02) << i;
  }
}

}  // namespace
}  // namespace weft::agents
