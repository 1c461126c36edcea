#include "agents/perception/clouds/cloud_window.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace weft::agents {
namespace {

constexpr float kCameraHighM = 0.5F;

/// Returns a frame from (x, 0) that sees the wall at x = 3.02 on a grid, and what else is given in the world.
SeenFrame frame_at(double x, const std::vector<Eigen::Vector3f>& also = {}) {
  SeenFrame frame{lift({x, 0.0, 0.0}), {}, {0.0F, 0.0F, kCameraHighM}};
  const auto dx = static_cast<float>(x);
  for (int y = -10; y <= 10; ++y) {
    frame.points_in_robot.emplace_back(3.02F - dx, 0.02F + 0.1F * static_cast<float>(y), 0.52F);
  }
  for (const Eigen::Vector3f& point : also)
    frame.points_in_robot.emplace_back(point - Eigen::Vector3f(dx, 0.0F, 0.0F));
  return frame;
}

bool has_point_near(const PlaceCloud& cloud, const Eigen::Vector3f& point) {
  return std::any_of(cloud.points.begin(), cloud.points.end(),
                     [&](const Eigen::Vector3f& other) { return (other - point).norm() < 0.03F; });
}

TEST(CloudWindow, TakesFramesOnlyWhereTheRobotHasMovedOrTurned) {
  CloudWindow window({}, {});
  EXPECT_TRUE(window.add(frame_at(0.0)));
  EXPECT_FALSE(window.add(frame_at(0.1)));
  EXPECT_TRUE(window.add(frame_at(0.13)));
  SeenFrame turned = frame_at(0.13);
  turned.odometry_from_robot = lift({0.13, 0.0, 0.2});
  EXPECT_TRUE(window.add(turned));
  for (int at = 1; at < 20; ++at) window.add(frame_at(0.13 + 0.13 * at));
  EXPECT_EQ(window.size(), 8U);
}

TEST(CloudWindow, KeepsWhatTwoFramesHitAndDropsWhatOneDid) {
  CloudWindow window({}, {});
  const Eigen::Vector3f flying(1.52F, 0.32F, 0.82F);
  const Eigen::Vector3f post(2.02F, 0.52F, 0.22F);
  window.add(frame_at(0.0, {flying, post}));
  window.add(frame_at(0.2, {post}));
  const PlaceCloud cloud = window.snapshot(lift({0.2, 0.0, 0.0}));
  EXPECT_FALSE(has_point_near(cloud, flying - Eigen::Vector3f(0.2F, 0.0F, 0.0F)));
  EXPECT_TRUE(has_point_near(cloud, post - Eigen::Vector3f(0.2F, 0.0F, 0.0F)));
  EXPECT_EQ(cloud.points.size(), 22U);
}

TEST(CloudWindow, ARobotThatStandsShowsWhatItsOnlyFrameHit) {
  CloudWindow window({}, {});
  window.add(frame_at(0.0));
  EXPECT_EQ(window.snapshot({}).points.size(), 21U);
}

TEST(CloudWindow, SaysWhichFrameSawAPointFromNearestAndWhereItsCameraStood) {
  CloudWindow window({}, {});
  window.add(frame_at(0.0));
  window.add(frame_at(0.5));
  const PlaceCloud cloud = window.snapshot(lift({0.5, 0.0, 0.0}));
  ASSERT_EQ(cloud.cameras.size(), 2U);
  EXPECT_LT((cloud.cameras[0] - Eigen::Vector3f(-0.5F, 0.0F, kCameraHighM)).norm(), 1e-5F);
  EXPECT_LT((cloud.place_from_frames[0].translation - Eigen::Vector3d(-0.5, 0.0, 0.0)).norm(), 1e-9);
  ASSERT_EQ(cloud.frames.size(), cloud.points.size());
  EXPECT_TRUE(std::all_of(cloud.frames.begin(), cloud.frames.end(), [](std::uint16_t frame) { return frame == 1; }));
  EXPECT_EQ(cloud.framed({}).camera_of(0), cloud.cameras[1].cast<double>());
}

TEST(CloudWindow, NearPointsWeighMoreWhereDepthIsNoisy) {
  const DepthNoise noise{300.0, 0.12, 0.3};
  CloudWindow window({}, noise);
  const SeenFrame far{lift({0.0, 0.0, 0.0}), {{4.01F, 0.0F, 0.0F}}, Eigen::Vector3f::Zero()};
  const SeenFrame near{lift({2.0, 0.0, 0.0}), {{2.04F, 0.0F, 0.0F}}, Eigen::Vector3f::Zero()};
  window.add(far);
  window.add(near);
  const PlaceCloud cloud = window.snapshot({});
  ASSERT_EQ(cloud.points.size(), 1U);
  EXPECT_GT(cloud.points[0].x(), 4.035F);  // by 2^4 to 1; the plain mean is 4.025
}

TEST(CloudWindow, ForgetsWhatWasSeenBeforeALongBlindStretch) {
  CloudWindow window({}, {});
  window.add(frame_at(0.0));
  window.add(frame_at(0.2));
  window.go_blind(0.2);
  EXPECT_EQ(window.size(), 2U);
  window.add(frame_at(0.25));  // hardly moved, and yet it saw: another stretch begins
  window.go_blind(0.2);
  EXPECT_EQ(window.size(), 2U);
  window.go_blind(0.2);
  EXPECT_EQ(window.size(), 0U);
}

TEST(CloudWindow, WithoutFramesItHasNoPoints) {
  const PlaceCloud cloud = CloudWindow({}, {}).snapshot({});
  EXPECT_TRUE(cloud.points.empty());
  EXPECT_TRUE(cloud.cameras.empty());
}

}  // namespace
}  // namespace weft::agents
