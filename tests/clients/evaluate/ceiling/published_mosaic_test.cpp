#include "clients/evaluate/ceiling/published_mosaic.hpp"

#include <gtest/gtest.h>

#include <variant>

#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"

namespace weft::evaluate::ceiling {
namespace {

/// Joins ten images of a flat ceiling along a straight way; returns where the mosaic has the robot, metres.
Eigen::Vector2d end_of_way(const agents::CameraModel& camera, PublishedMosaic& mosaic) {
  constexpr double ceiling_m = 4.0;
  test::RenderedCeiling flat;
  flat.panels.push_back(test::patterned(ceiling_m, test::box(-8.0, -8.0, 18.0, 16.0), 4));
  for (int i = 0; i <= 10; ++i) {
    const agents::View view = flat.view(camera, {0.06 * i, 0.0, 0.0}, {}, static_cast<std::uint64_t>(i) + 1);
    mosaic.add(std::get<agents::Image>(view.data));
  }
  return (ceiling_m - camera.robot_from_camera.translation.z()) * mosaic.robot_in_start();
}

TEST(PublishedMosaic, BelowAFlatCeilingAndStraightUpItIsRight) {
  const agents::CameraModel camera = test::up_camera();
  PublishedMosaic mosaic(camera);
  const Eigen::Vector2d end = end_of_way(camera, mosaic);
  EXPECT_EQ(mosaic.not_joined(), 0U);
  EXPECT_NEAR(end.x(), 0.6, 0.06);
  EXPECT_NEAR(end.y(), 0.0, 0.06);
}

TEST(PublishedMosaic, ItsRobotStandsWhereItBeganBeforeAnythingIsJoined) {
  PublishedMosaic mosaic(test::up_camera());
  EXPECT_EQ(mosaic.robot_in_start(), Eigen::Vector2d(0.0, 0.0));
}

}  // namespace
}  // namespace weft::evaluate::ceiling
