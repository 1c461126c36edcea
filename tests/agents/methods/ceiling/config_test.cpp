#include "agents/methods/ceiling/config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "agents/methods/ceiling/ceiling.hpp"
#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"

namespace weft::agents {
namespace {

TEST(CeilingConfig, DefaultsAreWithinTheirBounds) {
  EXPECT_THAT(check(CeilingConfig{}), testing::IsEmpty());
}

TEST(CeilingConfig, EveryBrokenBoundIsNamed) {
  CeilingConfig config;
  config.height_m = 0.5;
  config.corners = 3;
  config.window_px = 12;
  config.kappa = std::numeric_limits<double>::quiet_NaN();
  config.blind.wheel_distance_share = 0.0;
  const auto issues = check(config);
  for (const char* name : {"height_m", "corners = 3", "kappa", "window_px", "wheel_distance_share"})
    EXPECT_THAT(issues, testing::Contains(testing::HasSubstr(name)));
}

TEST(CeilingConfig, IsReadFromToml) {
  const config::Table table = config::parse(
      "height_m = 6.4\nheight_sigma_m = 0.02\ndetector = \"fast\"\n[blind]\nwheel_heading_share = 0.1\n", "a.toml");
  const CeilingConfig config = read_ceiling_config(table);
  EXPECT_TRUE(table.result()) << table.result().error().message;
  EXPECT_EQ(config.height_m, 6.4);
  EXPECT_EQ(config.height_sigma_m, 0.02);
  EXPECT_EQ(config.detector, CornerDetector::fast);
  EXPECT_EQ(config.blind.wheel_heading_share, 0.1);
}

TEST(CeilingConfig, AWrongOrUnknownKeyIsAnIssue) {
  const config::Table table = config::parse("height_m = 0.4\ndetector = \"sift\"\nheigth_m = 2.0\n", "a.toml");
  read_ceiling_config(table);
  EXPECT_EQ(table.issues().size(), 3U);
}

TEST(MakeCeiling, RefusesACameraThatDoesNotLookUpAndACeilingBelowIt) {
  CameraModel down = test::up_camera();
  down.robot_from_camera = downward_mount(0.0, 0.0, 0.6, 0.8, 0.0, 0.0);
  const Result<Ceiling> wrong = Ceiling::make({}, down);
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, testing::HasSubstr("look up"));
  CeilingConfig low;
  low.height_m = 1.2;
  EXPECT_THAT(Ceiling::make(low, test::up_camera(0.0, 0.0, 1.1)).error().message, testing::HasSubstr("height_m"));
}

}  // namespace
}  // namespace weft::agents
