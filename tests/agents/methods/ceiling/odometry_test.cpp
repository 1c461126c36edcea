#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "agents/methods/ceiling/ceiling.hpp"
#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"

namespace weft::agents {
namespace {

struct DrivenUnder {
  Ceiling::Odometry odometry;
  Pose2 truth{0.0, 0.0, 0.2};
  Pose2 seen{0.0, 0.0, 0.2};
  PlanarErrors common = PlanarErrors::Zero();
  std::map<std::string, int> blind;
  int samples = 0;
};

struct DriveUnder {
  int samples = 60;
  double step_m = 0.06;
  double wheels_share = 1.02;  ///< of what was driven
};

/// Drives a bending way below a ceiling with a camera whose mount is off by a third of a degree.
DrivenUnder drive_under(const Ceiling& method, test::RenderedCeiling& hall, const DriveUnder& how) {
  const CameraModel real = tilted(method.camera(), 0.006, -0.005);
  DrivenUnder run;
  Random random(5);
  for (; run.samples < how.samples; ++run.samples) {
    const double turn = 0.03 * std::sin(0.15 * run.samples);
    const bool moves = run.samples > 0;
    if (moves) run.truth = run.truth * se2_exp({how.step_m, 0.0, turn});
    const Attitude sway{random.normal(0.0, 0.0009), random.normal(0.0, 0.0009), random.normal(0.0, 0.0005)};
    const View view = hall.view(real, run.truth, sway, static_cast<std::uint64_t>(run.samples) + 1);
    Motion motion;
    motion.elapsed = std::chrono::milliseconds(100);
    motion.command = {10.0 * how.step_m, 10.0 * turn};
    motion.wheels = moves ? WheelStep{how.wheels_share * how.step_m, turn} : WheelStep{};
    const Step step = method.observe(run.odometry, &view, motion);
    if (!step.seen) ++run.blind[std::string(step.blind_reason)];
    run.seen = run.seen * planar(step.previous_from_current);
    run.common += in_plane(step.common);
  }
  return run;
}

Ceiling method_for(double height_m) {
  CeilingConfig config;
  config.height_m = height_m;
  return *Ceiling::make(config, test::up_camera(0.03, -0.02));
}

double length_of(const Pose2& pose) {
  return (Pose2{0.0, 0.0, 0.2}.inverse() * pose).translation().norm();
}

TEST(CeilingOdometry, IsRightBelowBeamsDuctsAndLamps) {
  test::RenderedCeiling hall = test::hall_ceiling(6.4);
  const DrivenUnder run = drive_under(method_for(6.4), hall, {});
  EXPECT_EQ(run.blind, (std::map<std::string, int>{{"first_view", 1}}));
  EXPECT_NEAR(length_of(run.seen) / length_of(run.truth), 1.0, 0.01);
  EXPECT_NEAR(run.seen.heading, run.truth.heading, 0.01);
}

TEST(CeilingOdometry, BeginsAsFarAsWheelsSayWhereMostOfWhatIsSeenHangs) {
  test::RenderedCeiling hall = test::hall_ceiling(6.4);
  for (const double y : {-5.0, -2.5, 0.0, 2.5})
    hall.panels.push_back(test::patterned(5.3, test::box(-9.0, y, 22.0, 2.2), 11));
  CeilingConfig config;
  config.height_m = 6.4;
  config.mount_tilt_rad = 0.003;  // as a calibration states it: heights are believed from the beginning
  const DrivenUnder run = drive_under(*Ceiling::make(config, test::up_camera(0.03, -0.02)), hall, {.samples = 9});
  EXPECT_NEAR(length_of(run.seen) / length_of(run.truth), 1.0, 0.05) << "all on the ceiling, it were 1.2";
}

TEST(CeilingOdometry, AWrongHeightIsWithinWhatItsCommonErrorsSay) {
  test::RenderedCeiling hall = test::hall_ceiling(6.4);
  CeilingConfig config;
  config.height_m = 6.4 * 1.03;
  config.height_sigma_m = 0.2;
  const Ceiling method = *Ceiling::make(config, test::up_camera(0.03, -0.02));
  const DrivenUnder run = drive_under(method, hall, {.samples = 40});
  const double off_m = std::abs(length_of(run.seen) - length_of(run.truth));
  EXPECT_GT(off_m, 0.02 * length_of(run.truth));
  EXPECT_LT(off_m, 3.0 * run.common.row(0).norm());
}

TEST(CeilingOdometry, HasNoScaleUntilWheelsTellIt) {
  test::RenderedCeiling hall = test::hall_ceiling(6.4);
  const Ceiling method = method_for(0.0);
  const DrivenUnder run = drive_under(method, hall, {.samples = 30, .step_m = 0.2, .wheels_share = 1.0});
  EXPECT_GT(run.blind.at("scale_unknown"), 20);
  ASSERT_TRUE(run.odometry.scale_by_wheels);
  EXPECT_NEAR(run.odometry.scale_by_wheels->ceiling_m, 6.4, 0.15);
  EXPECT_NEAR(run.odometry.scale_by_wheels->sigma_m, 0.03 * 5.8, 0.02);
  const View view = hall.view(method.camera(), run.truth, {}, 99);
  EXPECT_EQ(method.extract(Ceiling::Odometry{}, view).error().reason, "scale_unknown");
  EXPECT_TRUE(method.extract(run.odometry, view));
}

TEST(CeilingOdometry, WhatDrivesHaveShownOfTheMountIsBelievedOfAnyView) {
  const Ceiling method = method_for(6.4);
  test::RenderedCeiling hall = test::hall_ceiling(6.4);
  const DrivenUnder run = drive_under(method, hall, {.samples = 20});
  const View beside = hall.view(method.camera(), run.truth, {}, 1000);  // not the newest: odometry has not seen it
  const auto content = method.extract(run.odometry, beside);
  ASSERT_TRUE(content);
  const MountTilt tilt = run.odometry.mount->tilt();
  EXPECT_NE(tilt.pitch_rad, 0.0);
  EXPECT_EQ(content->attitude.pitch_rad, tilt.pitch_rad);
  EXPECT_EQ(content->attitude.roll_rad, tilt.roll_rad);
  EXPECT_GT(content->attitude_sigma.x(), std::sqrt(tilt.covariance(0, 0)));
  const auto before = method.extract({}, beside);
  ASSERT_TRUE(before);
  EXPECT_GE(before->attitude_sigma.x(), 3.0 * method.config().mount_tilt_rad);  // mounts get knocked
}

}  // namespace
}  // namespace weft::agents
