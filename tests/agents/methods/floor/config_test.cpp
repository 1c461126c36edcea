#include "agents/methods/floor/config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "agents/methods/floor/floor.hpp"
#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

TEST(FloorConfig, DefaultsAreWithinTheirBounds) {
  EXPECT_THAT(check(FloorConfig{}), testing::IsEmpty());
}

TEST(FloorConfig, EveryBrokenBoundIsNamed) {
  FloorConfig config;
  config.corners = 3;
  config.kappa = 1.5;
  config.eta_px = std::numeric_limits<double>::quiet_NaN();
  config.window_px = 12;
  config.blind.wheel_distance_share = 0.0;
  const auto issues = check(config);
  ASSERT_EQ(issues.size(), 5U);
  for (const char* name : {"corners = 3", "kappa", "eta_px", "window_px", "wheel_distance_share"})
    EXPECT_THAT(issues, testing::Contains(testing::HasSubstr(name)));
}

TEST(FloorConfig, IsReadFromToml) {
  const config::Table table =
      config::parse("kappa = 0.3\nfeatures = 400\n[blind]\nwheel_heading_share = 0.1\n", "a.toml");
  const FloorConfig config = read_floor_config(table);
  EXPECT_TRUE(table.result()) << table.result().error().message;
  EXPECT_EQ(config.kappa, 0.3);
  EXPECT_EQ(config.features, 400);
  EXPECT_EQ(config.blind.wheel_heading_share, 0.1);
  EXPECT_EQ(config.corners, FloorConfig{}.corners);
}

TEST(FloorConfig, AWrongOrUnknownKeyIsAnIssue) {
  const config::Table table = config::parse("kappa = 7\nkapa = 0.2\n", "a.toml");
  read_floor_config(table);
  EXPECT_EQ(table.issues().size(), 2U);
}

TEST(MakeFloor, RefusesAWrongCalibration) {
  CameraModel blind = test::paper_camera();
  blind.robot_from_camera = downward_mount(0.0, 0.0, 0.6, -0.8, 0.0, 0.0);  // looks at the ceiling
  const Result<Floor> up = Floor::make({}, blind);
  ASSERT_FALSE(up);
  EXPECT_EQ(up.error().code, ErrorCode::invalid);
  EXPECT_THAT(up.error().message, testing::HasSubstr("floor"));
  CameraModel broken = test::paper_camera();
  broken.fy = -1.0;
  EXPECT_FALSE(Floor::make({}, broken));
  FloorConfig config;
  config.ratio = 2.0;
  EXPECT_THAT(Floor::make(config, test::paper_camera()).error().message, testing::HasSubstr("ratio"));
}

}  // namespace
}  // namespace weft::agents
