#include "agents/methods/ceiling/mount_drive.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"

/// Tests the mount and the ceiling's height as a drive with a measured distance shows them.
namespace weft::agents {
namespace {

using SeenDrive = std::vector<std::pair<View, Motion>>;

/// Leads a camera that is truly `real` along a way that winds a little; returns what it sees, and where it ends.
SeenDrive led_under(test::RenderedCeiling& hall, const CameraModel& real, Pose2& truth) {
  Random random(101);
  SeenDrive drive;
  for (int i = 0; i < 80; ++i) {
    const double turn = 0.03 * std::sin(0.15 * i);
    if (i > 0) truth = truth * se2_exp({0.07, 0.0, turn});
    const Attitude sway{random.normal(0.0, 0.0009), random.normal(0.0, 0.0009), random.normal(0.0, 0.0005)};
    Motion motion;
    motion.elapsed = std::chrono::milliseconds(100);
    motion.command = {0.7, 10.0 * turn};
    motion.wheels = i > 0 ? WheelStep{1.02 * 0.07, turn} : WheelStep{};
    drive.emplace_back(hall.view(real, truth, sway, static_cast<std::uint64_t>(i) + 1), motion);
  }
  return drive;
}

PlayDrive played(const SeenDrive& drive) {
  return [&drive](const std::function<void(const View*, const Motion&)>& take) -> Result<void> {
    for (const auto& [view, motion] : drive) take(&view, motion);
    return {};
  };
}

TEST(CeilingMountDrive, FindsTheCeilingAboveWhatHangsBelowIt) {
  const CameraModel given = test::up_camera();
  test::RenderedCeiling hall = test::hall_ceiling(6.4);
  for (const double y : {-5.0, -1.0, 3.0})
    hall.panels.push_back(test::patterned(5.2, test::box(-9.0, y, 22.0, 1.6), 11));
  Pose2 truth;
  const SeenDrive drive = led_under(hall, tilted(given, 0.012, -0.01), truth);
  MountDriveConfig config;
  config.plane_m = 6.3;
  config.distance_m = truth.translation().norm();
  const Result<MountDrive> found = calibrate_ceiling_mount(given, played(drive), config);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->pitch_rad, 0.012, 0.003);
  EXPECT_NEAR(found->roll_rad, -0.01, 0.003);
  EXPECT_NEAR(found->plane_m, 6.4, 0.03);
  ASSERT_TRUE(found->plane_sigma_m());
  EXPECT_LT(std::abs(found->plane_m - 6.4), 3.0 * *found->plane_sigma_m());
}

TEST(CeilingMountDrive, WhatHangsOnOneSideIsNotTakenForATiltThatTheFileRulesOut) {
  CameraModel given = test::up_camera();
  given.sigma.tilt_rad = 0.005;
  const double roll_rad = -0.003;
  test::RenderedCeiling hall = test::hall_ceiling(6.4);
  hall.panels.push_back(test::patterned(5.8, test::box(-9.0, 1.0, 22.0, 5.0), 11));
  Pose2 truth;
  const SeenDrive drive = led_under(hall, tilted(given, 0.002, roll_rad), truth);
  MountDriveConfig config;
  config.plane_m = 6.4;
  config.distance_m = truth.translation().norm();
  const Result<MountDrive> found = calibrate_ceiling_mount(given, played(drive), config);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->roll_rad, roll_rad, 0.005);  // 0.009 off when the file states nothing
}

}  // namespace
}  // namespace weft::agents
