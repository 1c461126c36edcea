#include "clients/evaluate/ceiling/frames/tilt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "agents/perception/attitude.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/mount.hpp"
#include "clients/evaluate/ceiling/frames/recording.hpp"
#include "core/random.hpp"

namespace weft::evaluate::ceiling {
namespace {

constexpr double kAwayM = 2.5;

/// Returns corners of a level ceiling as a camera sees them twice, with noise of a quarter of a pixel.
SeenTwice seen_by(const agents::CameraModel& camera, const Pose2& a_from_b, Random& random) {
  SeenTwice seen;
  const auto in_view = [&](const Pose2& a_from_robot, const Eigen::Vector2d& point) -> Eigen::Vector2d {
    const Pose3 a_from_camera = lift(a_from_robot) * camera.robot_from_camera;
    const Eigen::Vector3d above(point.x(), point.y(), kRecordedMountM + kAwayM);
    const Eigen::Vector3d ray = a_from_camera.inverse() * above;
    const double noise = 0.25 / camera.fx;
    return ray.hnormalized() + Eigen::Vector2d(random.normal(0.0, noise), random.normal(0.0, noise));
  };
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector2d point(random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5));
    seen.in_a.push_back(in_view({}, point));
    seen.in_b.push_back(in_view(a_from_b, point));
  }
  return seen;
}

TEST(FoundTilt, IsThatOfTheCameraWhateverTheWay) {
  agents::CameraModel given;
  given.width = 640;
  given.height = 480;
  given.fx = given.fy = 190.0;
  given.cx = 320.0;
  given.cy = 240.0;
  given.lens = LensModel::equidistant;
  given = straight_up(given);
  const agents::CameraModel real = agents::tilted(given, 0.05, 0.30);
  Random random(3);
  std::vector<SeenTwice> pairs;
  for (const Pose2& way :
       {Pose2{0.3, 0.0, 0.05}, Pose2{0.25, 0.1, -0.1}, Pose2{0.3, -0.05, 0.2}, Pose2{0.2, 0.2, 0.0}})
    pairs.push_back(seen_by(real, way, random));
  const auto found = find_tilt(given, pairs, kAwayM);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pitch_rad, 0.05, 0.01);
  EXPECT_NEAR(found->roll_rad, 0.30, 0.01);
  EXPECT_LT(found->left_px, 1.0);
  EXPECT_GT(left_px(given, pairs, kAwayM), 2.0 * found->left_px);
  const Eigen::Vector2d ahead = travelled(real, pairs, kAwayM);
  EXPECT_NEAR(ahead.x(), 1.05, 0.05);
  EXPECT_NEAR(ahead.y(), 0.25, 0.05);
}

TEST(FoundTilt, LeavesPixelsOfTheImageHoweverFarOut) {
  constexpr double noise_px = 0.5;
  agents::CameraModel camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = camera.fy = 190.0;
  camera.cx = 320.0;
  camera.cy = 240.0;
  camera.lens = LensModel::equidistant;
  camera = straight_up(camera);
  Random random(5);
  SeenTwice seen;
  const auto noisy = [&](const Pose2& a_from_robot, const Eigen::Vector2d& point) {
    const Eigen::Vector3d ray = (lift(a_from_robot) * camera.robot_from_camera).inverse() *
                                Eigen::Vector3d(point.x(), point.y(), kRecordedMountM + kAwayM);
    const Eigen::Vector2d noise(random.normal(0.0, noise_px), random.normal(0.0, noise_px));
    return agents::normalised_from_pixel(camera, agents::pixel_from_normalised(camera, ray.hnormalized()) + noise);
  };
  for (int i = 0; i < 200; ++i) {
    const double around = random.uniform(-3.14, 3.14);
    const double out_m = kAwayM * std::tan(random.uniform(0.7, 0.9));
    const Eigen::Vector2d point = out_m * Eigen::Vector2d(std::cos(around), std::sin(around));
    seen.in_a.push_back(noisy({}, point));
    seen.in_b.push_back(noisy({0.3, 0.0, 0.05}, point));
  }
  // The mean length of a difference of two such errors, each way.
  EXPECT_NEAR(left_px(camera, {seen}, kAwayM), 1.2533 * std::sqrt(2.0) * noise_px, 0.1);
}

TEST(FoundTilt, IsNotSeenInFewViews) {
  EXPECT_FALSE(find_tilt(straight_up({}), {SeenTwice{}, SeenTwice{}}, kAwayM));
}

}  // namespace
}  // namespace weft::evaluate::ceiling
