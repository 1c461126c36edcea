#include "clients/evaluate/topometric/true_hall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace weft::evaluate::topometric {
namespace {

using agents::sim::Box;
using agents::sim::Obstacle;
using agents::sim::Site;

/// Has a plain wall, 2 m high, across x = 3 (its face at 2.9), and a crate of the second day.
Site walled() {
  Site site;
  site.hall.ceiling_m = 4.0;
  site.boxes.push_back({Box::Kind::wall, "wall", {3.0, 0.0, 0.0}, 0.2, 8.0, 2.0, 0.02, false});
  Obstacle crate;
  crate.site_from_obstacle = {1.5, 0.0, 0.7853981633974483};
  crate.length_m = crate.width_m = std::sqrt(2.0) * 0.3;
  crate.height_m = 0.3;
  crate.from_day = 1;
  site.obstacles.push_back(crate);
  return site;
}

TEST(TrueHall, RaysMeetWallsFloorAndCeiling) {
  const TrueHall hall(walled(), 0);
  const Eigen::Vector3d eye(0.0, 0.0, 0.5);
  EXPECT_NEAR(hall.meets_after(eye, {1.0, 0.2, 0.0}), 2.9, 1e-12);
  EXPECT_NEAR(hall.meets_after(eye, {1.0, 0.0, -0.5}), 1.0, 1e-12);
  EXPECT_NEAR(hall.meets_after(eye, {1.0, 0.0, 1.0}), 3.5, 1e-12) << "above the wall, as it is 2 m high";
  EXPECT_TRUE(std::isinf(hall.meets_after(eye, {-1.0, 0.0, 0.0})));
}

TEST(TrueHall, ObstaclesStandThereFromTheirDay) {
  const TrueHall hall(walled(), 1);
  EXPECT_NEAR(hall.meets_after({0.0, 0.0, 0.2}, {1.0, 0.0, 0.0}), 1.2, 1e-12) << "its corner";
  EXPECT_NEAR(hall.meets_after({0.0, 0.0, 0.5}, {1.0, 0.0, 0.0}), 2.9, 1e-12) << "over it";
}

TEST(TrueHall, RimsAreFartherOutsideAndNegativeInside) {
  const TrueHall hall(walled(), 0);
  EXPECT_NEAR(hall.to_rim_m({1.9, 0.0}), 1.0, 1e-12);
  EXPECT_NEAR(hall.to_rim_m({3.0, 1.0}), -0.1, 1e-12);
  EXPECT_NEAR(hall.to_rim_m({3.4, 4.4}), 0.5, 1e-12);
}

TEST(TrueHall, TheOutlineLiesOnRimsAndNotWhereTwoTouch) {
  Site site = walled();
  site.boxes.push_back({Box::Kind::wall, "more of it", {3.0, 6.0, 0.0}, 0.2, 4.0, 2.0, 1.0, true});
  const std::vector<OutlinePoint> outline = TrueHall(site, 0).outline(0.1);
  EXPECT_GT(outline.size(), 200U);
  const TrueHall hall(site, 0);
  for (const OutlinePoint& point : outline) {
    EXPECT_NEAR(hall.to_rim_m(point.in_site), 0.0, 1e-9);
    EXPECT_GT(hall.to_rim_m(point.in_site + 0.01 * point.outwards), 0.0);
    EXPECT_EQ(point.is_plain, point.in_site.y() < 4.0 + 1e-9) << point.in_site.transpose();
  }
  EXPECT_TRUE(std::none_of(outline.begin(), outline.end(), [](const OutlinePoint& point) {
    return std::abs(point.in_site.y() - 4.0) < 0.01;
  })) << "where the two walls meet there is no rim";
}

}  // namespace
}  // namespace weft::evaluate::topometric
