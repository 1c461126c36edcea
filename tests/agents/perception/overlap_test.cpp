#include "agents/perception/overlap.hpp"
#include "agents/perception/plane/geometry.hpp"

#include <gtest/gtest.h>

#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

const Polygon kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Polygon shifted(const Polygon& polygon, double x, double y) {
  Polygon out;
  for (const Eigen::Vector2d& p : polygon) out.emplace_back(p.x() + x, p.y() + y);
  return out;
}

SeenPlane seen(double far_m) {
  CameraModel camera;
  camera.robot_from_camera = downward_mount(0.0, 0.0, 0.6, 0.735, 0.0, 0.0);
  return {footprint(camera, Attitude{}, far_m), camera_from_floor(camera, Attitude{})};
}

TEST(Polygons, IntersectionOfShiftedSquares) {
  const Polygon other = shifted(kSquare, 0.25, 0.5);
  EXPECT_NEAR(area(intersection(kSquare, other)), 0.75 * 0.5, 1e-12);
  EXPECT_NEAR(area(intersection(other, kSquare)), 0.75 * 0.5, 1e-12);
  EXPECT_NEAR(area(intersection(kSquare, shifted(kSquare, 3.0, 0.0))), 0.0, 1e-12);
}

TEST(Polygons, ClockwiseIsTurned) {
  const Polygon clockwise(kSquare.rbegin(), kSquare.rend());
  EXPECT_LT(area(clockwise), 0.0);
  EXPECT_GT(area(counter_clockwise(clockwise)), 0.0);
}

TEST(Overlap, IsWholeInPlaceAndNoneFarAway) {
  const SeenPlane view = seen(10.0);
  EXPECT_NEAR(share_of_b_seen_in_a(view, view, Pose2{}), 1.0, 1e-9);
  EXPECT_EQ(share_of_b_seen_in_a(view, view, Pose2{9.0, 0.0, 0.0}), 0.0);
}

TEST(Overlap, OfAPitchedCameraSaysWhichShare) {
  // What the corrections of the paper state: at 0.25 m of travel 96 % one way and 56 % the other.
  const SeenPlane view = seen(10.0);
  EXPECT_NEAR(share_of_b_seen_in_a(view, view, Pose2{0.25, 0.0, 0.0}), 0.96, 0.02);
  EXPECT_NEAR(share_of_b_seen_in_a(view, view, Pose2{-0.25, 0.0, 0.0}), 0.56, 0.02);
}

TEST(Footprint, IsCutAtTheHorizon) {
  CameraModel level;
  level.robot_from_camera = downward_mount(0.0, 0.0, 0.6, 0.1, 0.0, 0.0);  // sees above the horizon
  const Polygon floor = footprint(level, Attitude{}, 3.0);
  ASSERT_GE(floor.size(), 3U);
  for (const Eigen::Vector2d& p : floor) {
    EXPECT_LE(p.x(), 3.0 + 1e-9);
    EXPECT_GT(p.x(), 0.0);
  }
}

}  // namespace
}  // namespace weft::agents
