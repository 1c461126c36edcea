#include "clients/evaluate/particles/carmen_log.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace weft::evaluate::particles {
namespace {

std::string line_of(const std::string& ranges, int count, const std::string& pose = "1 2 0.5") {
  return "FLASER " + std::to_string(count) + " " + ranges + " " + pose + " 0 0 0 12.5 host 12.5\n";
}

std::string log_of(int scans) {
  std::string text = "# a comment\nPARAM laser on 1.0 host 1.0\n";
  for (int i = 0; i < scans; ++i) text += line_of("1.5 2.5 3.5 80.0", 4);
  return text;
}

std::string message_of(const std::string& text) {
  const Result<std::vector<LaserScan>> scans = read_carmen(text, "a.log");
  EXPECT_FALSE(scans);
  return scans ? "" : scans.error().message;
}

TEST(CarmenLog, HasScansWithTheirPoses) {
  const Result<std::vector<LaserScan>> scans = read_carmen(log_of(9), "a.log");
  ASSERT_TRUE(scans) << scans.error().message;
  ASSERT_EQ(scans->size(), 9U);
  EXPECT_EQ(scans->front().map_from_laser, (Pose2{1.0, 2.0, 0.5}));
  EXPECT_EQ(scans->front().ranges_m, (std::vector<float>{1.5F, 2.5F, 3.5F, 80.0F}));
}

TEST(CarmenLog, AnEvenNumberOfRangesLeavesTheLastBearingOut) {
  LaserScan scan;
  scan.ranges_m.resize(180);
  EXPECT_NEAR(scan.bearing_rad(90), 0.0, 1e-12);
  EXPECT_NEAR(scan.bearing_rad(1) - scan.bearing_rad(0), std::numbers::pi / 180.0, 1e-12);
  scan.ranges_m.resize(361);
  EXPECT_NEAR(scan.bearing_rad(360), std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(scan.bearing_rad(180), 0.0, 1e-12);
}

TEST(CarmenLog, WhatIsWrongIsNamedWithItsLine) {
  const std::string good = log_of(9);
  EXPECT_EQ(message_of(good + "FLASER 4 1.0 2.0 3.0\n"),
            "a.log:12: FLASER of 4 ranges has 5 words, not 15: the line is cut or run together");
  EXPECT_EQ(message_of(good + "FLASER many 1.0\n"),
            "a.log:12: FLASER is not followed by a number of ranges in [2, 2000]");
  EXPECT_EQ(message_of(good + "FLASER\n"), "a.log:12: FLASER is not followed by a number of ranges in [2, 2000]");
  EXPECT_NE(message_of(good + line_of("1.5 -2.5 3.5 80.0", 4)).find("a.log:12: range 1 is"), std::string::npos);
  EXPECT_NE(message_of(good + line_of("1.5 nan 3.5 80.0", 4)).find("not in [0, 10000] m"), std::string::npos);
  EXPECT_NE(message_of(good + line_of("1.5 2.5 3.5 80.0", 4, "1 inf 0")).find("a.log:12: the pose"),
            std::string::npos);
  EXPECT_NE(message_of(good + line_of("1.5 2.5 3.5 80.0", 4, "1 2e9 0")).find("within 10 km"), std::string::npos);
  EXPECT_EQ(message_of(good + line_of("1.5 2.5", 2)),
            "a.log:12: a scan of 2 ranges, those before have 4; one laser is wanted");
}

TEST(CarmenLog, ALogWithTooFewScansIsRefused) {
  EXPECT_EQ(message_of("ODOM 0 0 0\n"),
            "a.log: holds 0 FLASER lines, at least 8 are wanted; give a CARMEN log with corrected poses");
  EXPECT_NE(message_of(log_of(7)).find("holds 7 FLASER lines"), std::string::npos);
  EXPECT_NE(message_of("").find("holds 0"), std::string::npos);
}

TEST(CarmenLog, AFileThatIsNotThereIsNamed) {
  const Result<std::vector<LaserScan>> scans = read_carmen_file("/nowhere/b.log.gz");
  ASSERT_FALSE(scans);
  EXPECT_EQ(scans.error().code, ErrorCode::not_found);
  EXPECT_NE(scans.error().message.find("/nowhere/b.log.gz"), std::string::npos);
}

}  // namespace
}  // namespace weft::evaluate::particles
