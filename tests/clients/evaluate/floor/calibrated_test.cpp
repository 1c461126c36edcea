#include "clients/evaluate/floor/calibrated.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "clients/evaluate/floor/scenario.hpp"

/// Tests the camera that is driven with, found by the tool that deployers use.
namespace weft::evaluate::floor {
namespace {

Stage stage_with_a_wrong_mount() {
  Stage stage;
  stage.site.robots.push_back({"r1", {2.0, 2.0, 0.0}, 5});
  stage.site.disturbances.mount_error_m = 0.03;
  stage.line = {{2.0, 2.0}, {6.0, 2.0}, {6.0, 7.0}};
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  stage.scratch = std::filesystem::path(testing::TempDir()) / ("weft-" + test + ".truth");  // tests run side by side
  stage.asked_to_stop = [] { return false; };
  return stage;
}

TEST(FloorCalibrated, FindsTheSpeedAndLeavesNoTruthBehind) {
  const Stage here = stage_with_a_wrong_mount();
  const auto scenario = Scenario::make(here, "polished-concrete", 2);
  ASSERT_TRUE(scenario) << scenario.error().message;
  const auto camera = calibrated(scenario->for_calibration(), scenario->calibration_line());
  ASSERT_TRUE(camera) << camera.error().message;
  ASSERT_TRUE(camera->has_value());
  EXPECT_FALSE(std::filesystem::exists(here.scratch));

  const auto off_by = [&](const std::optional<agents::CameraModel>& with) {
    Drive drive = scenario->first();
    drive.camera = with;
    const auto trace = lead(drive, scenario->line_beginning(3.0));
    if (!trace || !*trace) throw std::runtime_error("not driven");
    const std::vector<Moment>& moments = (*trace)->moments;
    const double seen = moments.back().start_from_robot.translation().norm();
    const double truly =
        (moments.front().site_from_robot.inverse() * moments.back().site_from_robot).translation().norm();
    return std::abs(seen / truly - 1.0);
  };
  EXPECT_GT(off_by(std::nullopt), 0.005) << "else nothing was tested";
  EXPECT_LT(off_by(*camera), 0.003);
}

TEST(FloorCalibrated, StopsWhenAskedAndLeavesNoTruthBehind) {
  const Stage here = stage_with_a_wrong_mount();
  const auto scenario = Scenario::make(here, "polished-concrete", 2);
  Drive drive = scenario->for_calibration();
  int samples = 0;
  drive.asked_to_stop = [&] { return ++samples > 30; };
  const auto camera = calibrated(drive, scenario->calibration_line());
  ASSERT_TRUE(camera) << camera.error().message;
  EXPECT_FALSE(camera->has_value());
  EXPECT_FALSE(std::filesystem::exists(here.scratch));
}

}  // namespace
}  // namespace weft::evaluate::floor
