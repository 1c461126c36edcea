#include "agents/methods/topometric/config.hpp"

#include <gmock/gmock.h>

namespace weft::agents {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

TopometricConfig read(const std::string& text, std::vector<std::string>& issues) {
  const config::Table root = config::parse(text, "t.toml");
  const TopometricConfig config = read_topometric_config(root.table("topometric"));
  issues = root.issues();
  return config;
}

TEST(TopometricConfig, DefaultsAreSound) {
  EXPECT_THAT(check(TopometricConfig{}), IsEmpty());
}

TEST(TopometricConfig, ReadsPartsByTheirTables) {
  std::vector<std::string> issues;
  const TopometricConfig config = read(
      "[topometric.window]\nframes = 5\n[topometric.local.arcs]\nspeeds = 7\n[topometric.ndt.cells]\nfinest_m = 0.3\n"
      "[topometric.odometry.gate]\nshare = 0.5\n[topometric.scan]\nbody_height_m = 1.2\n",
      issues);
  EXPECT_THAT(issues, IsEmpty());
  EXPECT_EQ(config.window.frames, 5U);
  EXPECT_EQ(config.local.arcs.speeds, 7);
  EXPECT_EQ(config.ndt.cells.finest_m, 0.3);
  EXPECT_EQ(config.open.gate.share, 0.5);
  EXPECT_EQ(config.scan.body_height_m, 1.2);
}

TEST(TopometricConfig, WhatIsOutOfBoundsOrUnknownIsNamed) {
  std::vector<std::string> issues;
  read("[topometric.window]\nframes = 99\n[topometric.sight]\nfar_m = 3\n", issues);
  EXPECT_THAT(issues, Contains(HasSubstr("topometric.window.frames")));
  EXPECT_THAT(issues, Contains(HasSubstr("far_m")));
}

TEST(TopometricConfig, EverySettingBeyondItsBoundIsNamed) {
  TopometricConfig config;
  config.sight.range_m = -1.0;
  config.relate.fewest_inliers = 1;
  config.filter.kld.cell_m = 100.0;
  const std::vector<std::string> issues = check(config);
  EXPECT_EQ(issues.size(), 3U);
  EXPECT_THAT(issues, Contains(HasSubstr("sight.range_m is -1")));
  EXPECT_THAT(issues, Contains(HasSubstr("relate.fewest_inliers")));
  EXPECT_THAT(issues, Contains(HasSubstr("filter.kld.cell_m")));
}

TEST(TopometricConfig, WhatDoesNotGoTogetherIsNamed) {
  std::vector<std::string> issues;
  read(
      "[topometric.window]\nframes = 2\nleast_frames = 3\n[topometric.scan]\nslice_from_m = 0.5\nbody_height_m = "
      "0.4\n",
      issues);
  EXPECT_THAT(issues, Contains(HasSubstr("least_frames exceeds frames")));
  EXPECT_THAT(issues, Contains(HasSubstr("body_height_m")));
  TopometricConfig config;
  config.disparity.disparities = 40;
  EXPECT_THAT(check(config), Contains(HasSubstr("no multiple of 16")));
}

}  // namespace
}  // namespace weft::agents
