#include "clients/evaluate/bearing/relocalise/aisles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace weft::evaluate::bearing {
namespace {

agents::sim::Site site_like() {
  agents::sim::Site site;
  site.robots.push_back({"r1", {1.0, 1.0, 0.0}, 3});
  site.boxes.push_back({});
  return site;
}

std::set<std::string> names_of(Loads loads) {
  std::set<std::string> names;
  for (const agents::sim::Box& box : aisles_like(site_like(), loads, 1).site.boxes) names.insert(box.name);
  return names;
}

/// Returns the distance to the nearest of the racks and the hall's walls.
double room_m(const agents::sim::Site& site, const agents::SitePoint& at) {
  double room =
      std::min({at.x - site.floor.x_min, site.floor.x_max - at.x, at.y - site.floor.y_min, site.floor.y_max - at.y});
  for (const agents::sim::Box& box : site.boxes) {
    const double dx = std::max(0.0, std::abs(at.x - box.site_from_box.x) - 0.5 * box.length_m);
    const double dy = std::max(0.0, std::abs(at.y - box.site_from_box.y) - 0.5 * box.width_m);
    room = std::min(room, std::hypot(dx, dy));
  }
  return room;
}

TEST(LookAlikeAisles, HoldWhatIsAskedFor) {
  EXPECT_EQ(names_of(Loads::other).size(), 2 * Aisles::kCount);
  EXPECT_EQ(names_of(Loads::one_side).size(), Aisles::kCount + 1);
  EXPECT_EQ(names_of(Loads::same).size(), 2U);
}

TEST(LookAlikeAisles, OneIsLeftOutBySeed) {
  std::set<std::size_t> left_out;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Aisles aisles = aisles_like(site_like(), Loads::other, seed);
    left_out.insert(aisles.left_out);
    EXPECT_EQ(aisles.taught().size(), Aisles::kCount - 1);
    for (const std::size_t aisle : aisles.taught()) EXPECT_NE(aisle, aisles.left_out);
  }
  EXPECT_EQ(left_out.size(), Aisles::kCount);
}

TEST(LookAlikeAisles, RobotsAreLedWhereThereIsRoomForThem) {
  const Aisles aisles = aisles_like(site_like(), Loads::other, 1);
  constexpr double kRobotM = 0.3;
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const PutDown put_down = i % 2 == 0 ? anywhere(random) : on_the_line(random.below(Aisles::kCount), random);
    EXPECT_GT(room_m(aisles.site, {put_down.site_from_robot.x, put_down.site_from_robot.y}), kRobotM);
    for (const agents::SitePoint& point : put_down.way) EXPECT_GT(room_m(aisles.site, point), kRobotM);
    const agents::SitePoint& a = put_down.way.front();
    const agents::SitePoint& b = put_down.way.back();
    EXPECT_GE(std::hypot(b.x - a.x, b.y - a.y), kLedM);
  }
}

}  // namespace
}  // namespace weft::evaluate::bearing
