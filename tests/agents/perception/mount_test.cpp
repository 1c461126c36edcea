#include "agents/perception/mount.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "agents/perception/lens.hpp"
#include "core/random.hpp"
#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Returns what a camera truly mounted as `truth` sees between two stands, told as to one mounted as given.
PlaneViews seen(const CameraModel& truth, const Pose2& a_from_b, Random& random, double noise_px = 0.15) {
  const auto shake = [&] {
    return Attitude{0.0009 * random.normal(), 0.0009 * random.normal(), 0.001 * random.normal()};
  };
  const PlanarState state{a_from_b, shake(), shake()};
  PlaneViews views{{}, a_from_b, a_from_b};
  while (views.points.size() < 90) {
    const Eigen::Vector2d pixel(20.0 + 712.0 * random.uniform(), 150.0 + 310.0 * random.uniform());
    const Eigen::Vector2d in_a = normalised_from_pixel(truth, pixel);
    const Reprojection there = reproject(truth, truth, state, in_a);
    if (!there.in_front) continue;
    const Eigen::Vector2d noise = noise_px / focal_px(truth) * Eigen::Vector2d(random.normal(), random.normal());
    views.points.push_back({in_a, there.in_b + noise, noise_px});
  }
  return views;
}

Pose2 arc(double metres, double turn_rad) {
  return se2_exp(Eigen::Vector3d(metres, 0.0, turn_rad));
}

TEST(MountFilter, FindsPitchAndRollAndHowWell) {
  const CameraModel given = test::paper_camera();
  int within = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const double pitch = 0.6 * kDegree * random.normal();
    const double roll = 0.6 * kDegree * random.normal();
    const CameraModel truth = tilted(given, pitch, roll);
    MountFilter filter(given, {.tilt_rad = 0.1, .focal_share = 1e-6});
    for (int i = 0; i < 30; ++i) ASSERT_TRUE(filter.add(seen(truth, arc(0.2, 0.1 * random.normal()), random)));
    const MountTilt found = filter.tilt();
    EXPECT_EQ(filter.pairs(), 30U);
    EXPECT_NEAR(found.pitch_rad, pitch, 0.04 * kDegree) << seed;
    EXPECT_NEAR(found.roll_rad, roll, 0.04 * kDegree) << seed;
    const Eigen::Vector2d error(found.pitch_rad - pitch, found.roll_rad - roll);
    if (error.dot(found.covariance.inverse() * error) < 5.99) ++within;  // 95 % of chi squared with two degrees
  }
  EXPECT_GE(within, 17);
}

TEST(MountFilter, KnowsNothingBeforeItHasSeen) {
  const MountFilter filter(test::paper_camera(), {.tilt_rad = 0.05});
  EXPECT_EQ(filter.tilt().pitch_rad, 0.0);
  EXPECT_NEAR(filter.tilt().sigma_rad(), 0.05, 1e-9);
}

TEST(MountFilter, CountsWhatTheFocalLengthMayDo) {
  const CameraModel given = test::paper_camera();
  Random random(4);
  MountFilter sure(given, {.focal_share = 1e-6});
  MountFilter unsure(given, {.focal_share = 0.003});
  for (int i = 0; i < 20; ++i) {
    const PlaneViews views = seen(given, arc(0.2, 0.0), random);
    sure.add(views);
    unsure.add(views);
  }
  EXPECT_NEAR(sure.tilt().pitch_rad, unsure.tilt().pitch_rad, 1e-12);
  EXPECT_GT(unsure.tilt().sigma_rad(), 3.0 * sure.tilt().sigma_rad());
}

TEST(MountFilter, LearnsNothingOfWhatIsNoFloor) {
  Random random(4);
  MountFilter filter(test::paper_camera(), {});
  PlaneViews views = seen(test::paper_camera(), arc(0.2, 0.0), random);
  for (PlanePair& point : views.points) point.in_b += 0.05 * Eigen::Vector2d(random.normal(), random.normal());
  EXPECT_FALSE(filter.add(views));
  EXPECT_EQ(filter.pairs(), 0U);
}

TEST(MountWatch, ReportsTiltAndTheWheelsHeightAndForgets) {
  const CameraModel given = test::paper_camera();
  Random random(6);
  MountWatch watch(given, {.tilt_rad = 0.018, .focal_share = 1e-6});
  const auto drive = [&](const CameraModel& truth, int pairs) {
    for (int i = 0; i < pairs; ++i) {
      PlaneViews views = seen(truth, arc(0.2, 0.05 * random.normal()), random);
      views.wheels = arc(0.202, 0.0);
      watch.add(views);
    }
  };
  drive(tilted(given, 0.01, 0.0), 5);
  EXPECT_FALSE(watch.report());
  drive(tilted(given, 0.01, 0.0), 25);
  ASSERT_TRUE(watch.report());
  EXPECT_NEAR(watch.report()->tilt.pitch_rad, 0.01, 0.001);
  ASSERT_TRUE(watch.report()->height_by_wheels);
  EXPECT_NEAR(*watch.report()->height_by_wheels, 0.01, 0.002);
  drive(tilted(given, -0.005, 0.0), 500);
  EXPECT_NEAR(watch.report()->tilt.pitch_rad, -0.005, 0.002);
}

TEST(MountWatch, WithoutWheelsTheHeightIsNotObservable) {
  Random random(6);
  MountWatch watch(test::paper_camera(), {});
  for (int i = 0; i < 12; ++i) {
    PlaneViews views = seen(test::paper_camera(), arc(0.2, 0.0), random);
    views.wheels.reset();
    watch.add(views);
  }
  ASSERT_TRUE(watch.report());
  EXPECT_FALSE(watch.report()->height_by_wheels);
}

/// Returns motions of a robot as it appears through a mount that is off by yaw and ahead.
std::vector<Pose2> through(double yaw_rad, double ahead_m, double turn_rad, double noise_m, Random& random) {
  const Pose2 believed_from_true{-ahead_m, 0.0, -yaw_rad};
  std::vector<Pose2> motions;
  for (int i = 0; i < 40; ++i) {
    Pose2 m = believed_from_true * arc(0.2, turn_rad * std::sin(0.4 * i)) * believed_from_true.inverse();
    m.x += noise_m * random.normal();
    m.y += noise_m * random.normal();
    motions.push_back(m);
  }
  return motions;
}

TEST(MountLever, YawFromStraightsAndPlaceFromBends) {
  Random random(9);
  const auto bends = lever_from(through(0.02, 0.03, 0.15, 0.0005, random), 0.05, 0.02);
  ASSERT_TRUE(bends);
  EXPECT_NEAR(bends->yaw_rad, 0.02, 0.002);
  EXPECT_NEAR(bends->forward_m, 0.03, 0.004);
  EXPECT_LT(bends->yaw_sigma_rad, 0.002);
  EXPECT_LT(bends->forward_sigma_m, 0.005);
  const auto straight = lever_from(through(0.02, 0.03, 0.0, 0.0005, random), 0.05, 0.02);
  ASSERT_TRUE(straight);
  EXPECT_NEAR(straight->yaw_rad, 0.02, 0.002);
  EXPECT_NEAR(straight->forward_m, 0.0, 1e-6);
  EXPECT_NEAR(straight->forward_sigma_m, 0.02, 1e-6);
}

TEST(MountLever, FewMotionsSayNothing) {
  EXPECT_FALSE(lever_from(std::vector<Pose2>(4), 0.05, 0.02));
}

TEST(MountLever, IsAppliedTheWayItWasFound) {
  const CameraModel given = test::paper_camera();
  const CameraModel moved = shifted(given, {0.1, 0.03, 0.0, 0.0});
  EXPECT_NEAR(moved.robot_from_camera.translation.x(), given.robot_from_camera.translation.x() + 0.03, 1e-12);
  const Eigen::Vector3d ahead = moved.robot_from_camera.rotation * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(std::atan2(ahead.y(), ahead.x()), 0.1, 1e-9);
}

}  // namespace
}  // namespace weft::agents
