#include "agents/methods/open_odometry.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "tests/support/stereo_room.hpp"

namespace weft::agents {
namespace {

using namespace std::chrono_literals;

/// Drives through a room as commanded, half a metre a second for 0.1 s a view.
class OpenDrive {
 public:
  OpenDrive() : odometry_(std::move(*OpenOdometry::make({}, sensor_))) {}

  /// Returns the step of the next view. `light`: by which its grey levels are multiplied; `wheels`: as they report.
  Step next(double light = 1.0, std::optional<WheelStep> wheels = {}) {
    const Motion motion{100ms, {0.4, 0.2}, wheels};
    at_ = at_ * se2_exp({0.04, 0.0, 0.02});
    View view;
    test::StereoShot shot;
    shot.gain = light;
    shot.seed = seed_++;
    view.data = room_.pair(sensor_, lift(at_), shot);
    return odometry_.observe(state_, &view, motion);
  }
  Step without_view() { return odometry_.observe(state_, nullptr, {100ms, {0.4, 0.2}, std::nullopt}); }
  const OpenOdometry& odometry() const { return odometry_; }

 private:
  Sensor sensor_ = test::stereo_sensor(320, 240, 208.0, 0.12);
  test::StereoRoom room_ = test::crate_room();
  OpenOdometry odometry_;
  OpenOdometry::State state_;
  Pose2 at_{1.0, 0.0, -0.1};
  std::uint64_t seed_ = 1;
};

TEST(OpenOdometry, StepsAreSeenOrCommanded) {
  OpenDrive drive;
  EXPECT_FALSE(drive.next().seen);
  const Step seen = drive.next();
  EXPECT_TRUE(seen.seen) << seen.blind_reason;
  const Step dark = drive.next(0.02);
  EXPECT_FALSE(dark.seen);
  EXPECT_EQ(dark.blind_reason, "too_dark");
  EXPECT_NEAR(planar(dark.previous_from_current).x, 0.04, 0.005) << "as commanded";
  EXPECT_GT(planar_covariance(dark.previous_from_current)(0, 0), planar_covariance(seen.previous_from_current)(0, 0));
  const Step again = drive.next();
  EXPECT_TRUE(again.seen) << again.blind_reason;
}

TEST(OpenOdometry, WheelsAreNotLookedAt) {
  OpenDrive drive;
  drive.next();
  const Step dark = drive.next(0.02, WheelStep{5.0, 1.0});
  EXPECT_FALSE(dark.seen);
  EXPECT_NEAR(planar(dark.previous_from_current).x, 0.04, 0.005);
}

TEST(OpenOdometry, WhatCommandsCannotHaveCausedIsBlind) {
  OpenDrive drive;
  drive.next();
  drive.next();
  View view;
  const test::StereoRoom room = test::crate_room();
  const Sensor sensor = test::stereo_sensor(320, 240, 208.0, 0.12);
  view.data = room.pair(sensor, lift(Pose2{1.4, 0.0, -0.06}));
  OpenOdometry::State state;
  View first;
  first.data = room.pair(sensor, lift(Pose2{1.0, 0.0, -0.06}));
  const Motion standing{100ms, {}, std::nullopt};
  drive.odometry().observe(state, &first, standing);
  const Step step = drive.odometry().observe(state, &view, standing);
  EXPECT_FALSE(step.seen);
  EXPECT_EQ(step.blind_reason, "impossible");
}

TEST(OpenOdometry, SeenAgainItMakesUpForALongBlindStretchThatWasAssumedWrongly) {
  const Sensor sensor = test::stereo_sensor(320, 240, 208.0, 0.12);
  const test::StereoRoom room = test::crate_room();
  const OpenOdometry odometry = std::move(*OpenOdometry::make({}, sensor));
  OpenOdometry::State state;
  const auto view_at = [&](const Pose2& at, double light) {
    View view;
    test::StereoShot shot;
    shot.gain = light;
    view.data = room.pair(sensor, lift(at), shot);
    return view;
  };
  const Motion commanded{100ms, {0.5, 0.0}, std::nullopt};
  Relation start_from_robot = Metric3{};
  Pose2 at{1.0, 0.0, -0.1};
  for (int i = 0; i < 10; ++i) {
    const bool is_dark = i >= 2 && i < 9;
    at =
        at * se2_exp({i == 0 ? 0.0 : 0.025, 0.0, 0.0});  // half of what was commanded: it is off by 0.2 m in the dark
    const View view = view_at(at, is_dark ? 0.02 : 1.0);
    const Step step = odometry.observe(state, &view, commanded);
    EXPECT_EQ(step.seen, i > 0 && !is_dark) << i << step.blind_reason;
    if (i > 0) start_from_robot = compose(start_from_robot, step.previous_from_current);
  }
  EXPECT_NEAR(planar(start_from_robot).x, 9 * 0.025, 0.01);
}

TEST(OpenOdometry, APairThatComesAgainIsFrozen) {
  const Sensor sensor = test::stereo_sensor(320, 240, 208.0, 0.12);
  const test::StereoRoom room = test::crate_room();
  const OpenOdometry odometry = std::move(*OpenOdometry::make({}, sensor));
  OpenOdometry::State state;
  const Motion motion{100ms, {0.4, 0.0}, std::nullopt};
  View view;
  for (int i = 0; i < 3; ++i) {
    test::StereoShot shot;
    shot.seed = static_cast<std::uint64_t>(i) + 1;
    view.data = room.pair(sensor, lift(Pose2{1.0 + 0.04 * i, 0.0, 0.0}), shot);
    odometry.observe(state, &view, motion);
  }
  auto& again = std::get<StereoPair>(view.data);
  again.left.pixels = std::make_shared<const Bytes>(*again.left.pixels);
  const Step step = odometry.observe(state, &view, motion);
  EXPECT_FALSE(step.seen);
  EXPECT_EQ(step.blind_reason, "frozen");
  EXPECT_NEAR(planar(step.previous_from_current).x, 0.04, 0.005) << "as commanded, not standing";
}

TEST(OpenOdometry, WhatIsNoPairIsNamed) {
  OpenDrive drive;
  EXPECT_EQ(drive.without_view().blind_reason, "dropped_frame");
  OpenOdometry::State state;
  View view;
  view.data = Payload{};
  EXPECT_EQ(drive.odometry().observe(state, &view, {100ms, {}, std::nullopt}).blind_reason, "not_a_pair");
}

}  // namespace
}  // namespace weft::agents
