#include "clients/evaluate/floor/relocalise/hall.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "clients/evaluate/floor/scenario.hpp"

namespace weft::evaluate::floor {
namespace {

agents::sim::Site site_with_a_lamp() {
  agents::sim::Site site;
  site.robots.push_back({"r1", {5.0, 5.0, 1.0}, 3});
  site.lamps.push_back({1.0, 1.0, 6.0, 0.9});
  site.boxes.push_back({});
  return site;
}

TEST(HallOfRelocalisation, IsAsLongAsAskedAndLittleLonger) {
  for (const double metres : {10.0, 100.0, 1000.0}) {
    const double length_m = length_of(hall_like(site_with_a_lamp(), metres).line);
    EXPECT_GE(length_m, metres - 0.5);
    EXPECT_LE(length_m, metres + 45.0);
  }
}

TEST(HallOfRelocalisation, TheLineLiesWithinAndTheRobotStandsAtItsStart) {
  const Hall hall = hall_like(site_with_a_lamp(), 300.0);
  for (const agents::SitePoint& point : hall.line) {
    EXPECT_GT(point.x, hall.site.floor.x_min + 1.0);
    EXPECT_LT(point.x, hall.site.floor.x_max - 1.0);
    EXPECT_GT(point.y, hall.site.floor.y_min + 1.0);
    EXPECT_LT(point.y, hall.site.floor.y_max - 1.0);
  }
  EXPECT_EQ(hall.site.robots.front().site_from_robot, (Pose2{hall.line[0].x, hall.line[0].y, 0.0}));
  EXPECT_TRUE(hall.site.boxes.empty());
  EXPECT_GT(hall.site.lamps.size(), 10U);
}

TEST(HallOfRelocalisation, TurnsAreNoTighterThanItsRows) {
  const Hall hall = hall_like(site_with_a_lamp(), 100.0);
  for (std::size_t i = 2; i < hall.line.size(); ++i) {
    const auto heading = [&](std::size_t k) {
      return std::atan2(hall.line[k].y - hall.line[k - 1].y, hall.line[k].x - hall.line[k - 1].x);
    };
    EXPECT_LT(std::abs(wrap_angle(heading(i) - heading(i - 1))), 0.5);
  }
}

}  // namespace
}  // namespace weft::evaluate::floor
