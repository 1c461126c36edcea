#include "clients/evaluate/odometry/regions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::evaluate::odometry {
namespace {

/// Returns the row of a robot whose region held so many of ten stretches.
Row robot(std::uint64_t seed, int held, const char* observer = kCalibrated) {
  Row row;
  row.kind = "wood";
  row.seed = seed;
  row.drive = kMappingDrive;
  row.observer = observer;
  for (int i = 0; i < 10; ++i) row.over_1m.push_back(i < held ? 1.0 : 20.0);
  return row;
}

std::vector<Row> robots(std::uint64_t count, int held) {
  std::vector<Row> rows;
  for (std::uint64_t seed = 1; seed <= count; ++seed) rows.push_back(robot(seed, held));
  return rows;
}

TEST(OdometryRegions, AreTheMeanOverRobotsHoweverFarEachDrove) {
  std::vector<Row> rows = {robot(1, 10), robot(2, 5), robot(2, 5)};
  const Region calibrated = regions_of(rows).front();
  EXPECT_EQ(calibrated.robots, 2U);
  EXPECT_EQ(calibrated.metres, 1.0);
  EXPECT_NEAR(calibrated.held_percent, 75.0, 1e-9);
}

TEST(OdometryRegions, OtherDrivesAndObserversDoNotCount) {
  std::vector<Row> rows = {robot(1, 10), robot(2, 0, kAsGiven), robot(3, 0)};
  rows.back().drive = "1.5 m/s";
  EXPECT_NEAR(regions_of(rows)[0].held_percent, 100.0, 1e-9);
  EXPECT_NEAR(regions_of(rows)[2].held_percent, 0.0, 1e-9);
  EXPECT_TRUE(std::isnan(regions_of(rows)[1].held_percent)) << "nobody drove 10 m";
}

TEST(OdometryRegions, AreJudgedFromFortyRobotsOn) {
  EXPECT_FALSE(is_any_missed(regions_of(robots(39, 5))));
  EXPECT_TRUE(is_any_missed(regions_of(robots(40, 5)))) << "believes too much";
  EXPECT_TRUE(is_any_missed(regions_of(robots(40, 10)))) << "believes too little";
  std::vector<Row> mixed = robots(40, 10);
  for (std::size_t i = 0; i < 20; ++i) mixed[i] = robot(i + 1, 9);
  EXPECT_FALSE(is_any_missed(regions_of(mixed)));
  EXPECT_NE(words_of(regions_of(robots(40, 5))).find("50.0 %, mean of 40 robots (asked 90 to 98: MISSED)"),
            std::string::npos)
      << words_of(regions_of(robots(40, 5)));
}

}  // namespace
}  // namespace weft::evaluate::odometry
