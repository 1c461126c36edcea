#include "agents/perception/stereo/disparity.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/perception/opencv_view.hpp"
#include "agents/perception/stereo/rectifier.hpp"
#include "clients/evaluate/stereo/sgbm.hpp"
#include "tests/agents/perception/stereo/judged.hpp"
#include "tests/support/stereo_room.hpp"

namespace weft::agents {
namespace {

using test::judged;

const Pose3 kStart = lift(Pose2{1.0, 0.0, 0.0});

struct Looked {
  Sensor sensor = test::stereo_sensor(320, 240, 208.0, 0.12);
  StereoPair pair;
  std::vector<double> depth_m;
  StereoRig rig;

  explicit Looked(const test::StereoRoom& room, const Pose3& at = kStart) {
    pair = room.pair(sensor, at);
    depth_m = room.look(sensor.camera, at * sensor.camera.robot_from_camera).depth_m;
    rig = Rectifier::make(sensor)->rig();
  }
};

TEST(Disparity, OfARoomIsRight) {
  const Looked looked(test::crate_room());
  DisparityConfig config;
  config.disparities = 48;
  const auto map = match_disparity(config, looked.pair);
  ASSERT_TRUE(map) << map.error().reason;
  const test::Judged found = judged(*map, looked.rig, looked.depth_m, config.disparities);
  EXPECT_GT(found.density, 0.80);
  EXPECT_LT(found.off_1px, 0.04);
  EXPECT_LT(found.off_2px, 0.025);
  EXPECT_LT(found.mean_px, 0.4);
}

TEST(Disparity, IsAsDenseAndAsRightAsSgbm) {
  const Looked looked(test::crate_room(8));
  DisparityConfig config;
  config.disparities = 48;
  const auto map = match_disparity(config, looked.pair);
  ASSERT_TRUE(map);
  const test::Judged ours = judged(*map, looked.rig, looked.depth_m, config.disparities);
  const test::Judged theirs =
      judged(evaluate::stereo::sgbm(looked.pair, config.disparities), looked.rig, looked.depth_m, config.disparities);
  EXPECT_LT(ours.off_2px, theirs.off_2px + 0.002);
  EXPECT_GT(ours.density, theirs.density - 0.01);
}

TEST(Disparity, PlainWallsHaveNone) {
  const test::StereoRoom room(3, {{-1.0, -3.0, 0.0}, {8.0, 3.0, 3.0}, 0.0, 120.0},
                              {{{3.0, -0.6, 0.0}, {3.6, 0.0, 0.9}, 45.0, 110.0}});
  const Looked looked(room);
  const auto map = match_disparity({}, looked.pair);
  ASSERT_TRUE(map) << map.error().reason;
  constexpr int beside_px = 8;  // windows reach beyond the crate's edges
  cv::Mat is_crate(map->height, map->width, CV_8U);
  for (std::size_t i = 0; i < looked.depth_m.size(); ++i)
    is_crate.data[i] = looked.depth_m[i] < 2.2 && looked.depth_m[i] > 1.7 ? 1 : 0;
  cv::Mat around;
  cv::dilate(is_crate, around, cv::Mat::ones(2 * beside_px + 1, 2 * beside_px + 1, CV_8U));
  std::size_t on_walls = 0;
  std::size_t on_crate = 0;
  for (std::size_t i = 0; i < looked.depth_m.size(); ++i) {
    if (map->sixteenths[i] == DisparityMap::none) continue;
    on_crate += is_crate.data[i];
    on_walls += around.data[i] == 0 ? 1U : 0U;
  }
  EXPECT_GT(on_crate, 1000U);
  EXPECT_EQ(on_walls, 0U);
  DisparityConfig ungated;
  ungated.least_texture = ungated.least_matched = 0.0;
  const auto all = match_disparity(ungated, looked.pair);
  ASSERT_TRUE(all);
  EXPECT_GT(density(*all), density(*map));
}

TEST(Disparity, ACoveredLensIsNamed) {
  Looked looked(test::crate_room());
  const StereoPair left{test::filled(looked.pair.left, 90), looked.pair.right};
  EXPECT_EQ(match_disparity({}, left).error().reason, "covered");
  const StereoPair right{looked.pair.left, test::filled(looked.pair.left, 4)};
  EXPECT_EQ(match_disparity({}, right).error().reason, "covered");
  const StereoPair both{test::filled(looked.pair.left, 4), test::filled(looked.pair.left, 5)};
  EXPECT_EQ(match_disparity({}, both).error().reason, "too_dark");
}

TEST(Disparity, ImagesOfTwoMomentsAreDecorrelated) {
  const test::StereoRoom room = test::crate_room();
  const Looked now(room);
  const Pose3 pitched =
      kStart * Pose3{Eigen::Quaterniond(Eigen::AngleAxisd(0.08, Eigen::Vector3d::UnitY())), Eigen::Vector3d::Zero()};
  const Looked later(room, pitched);
  const auto map = match_disparity({}, {now.pair.left, later.pair.right});
  ASSERT_FALSE(map) << density(*map);
  EXPECT_EQ(map.error().reason, "decorrelated");
  EXPECT_LT(map.error().measured, map.error().bound);
}

TEST(Disparity, AnotherRoomIsDecorrelated) {
  const Looked here(test::crate_room());
  const Looked elsewhere(test::crate_room(77));
  for (const int disparities : {48, 64, 128}) {
    DisparityConfig config;
    config.disparities = disparities;
    const auto map = match_disparity(config, {here.pair.left, elsewhere.pair.right});
    ASSERT_FALSE(map) << density(*map);
    EXPECT_EQ(map.error().reason, "decorrelated") << disparities << " disparities";
  }
}

TEST(Disparity, WhatIsNearerThanSearchedIsTooNear) {
  const Looked looked(
      {3, {{-1.0, -3.0, 0.0}, {8.0, 3.0, 3.0}, 45.0, 120.0}, {{{1.45, -1.0, 0.0}, {2.0, 1.0, 1.5}, 45.0, 110.0}}});
  DisparityConfig config;
  config.disparities = 48;  // down to 0.54 m; the block is 0.35 m away
  const auto map = match_disparity(config, looked.pair);
  ASSERT_FALSE(map) << density(*map);
  EXPECT_EQ(map.error().reason, "too_near");
  EXPECT_NEAR(map.error().measured, looked.rig.disparity_px(0.35), 6.0);
  EXPECT_EQ(map.error().bound, 46.0);
  config.disparities = 96;
  const auto wider = match_disparity(config, looked.pair);
  ASSERT_TRUE(wider) << wider.error().reason;
  EXPECT_LT(judged(*wider, looked.rig, looked.depth_m, config.disparities).off_1px, 0.04);
}

TEST(Disparity, AShiftOfTheRightImageMovesAllDepthsByTheFormula) {
  const Looked looked(test::crate_room());
  const std::size_t pixels = looked.pair.right.pixels->size();
  Bytes moved(pixels);
  const auto width = static_cast<std::size_t>(looked.pair.right.width);
  for (std::size_t i = 0; i < pixels; ++i) moved[i] = (*looked.pair.right.pixels)[i % width + 2 < width ? i + 2 : i];
  const Image right{looked.pair.right.width, looked.pair.right.height,
                    std::make_shared<const Bytes>(std::move(moved))};
  const auto as_is = match_disparity({}, looked.pair);
  const auto shifted = match_disparity({}, {looked.pair.left, right});
  ASSERT_TRUE(as_is && shifted);
  int both = 0;
  int by_two = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (as_is->sixteenths[i] == DisparityMap::none || shifted->sixteenths[i] == DisparityMap::none) continue;
    ++both;
    by_two += std::abs(shifted->sixteenths[i] - as_is->sixteenths[i] - 32) <= 8 ? 1 : 0;
  }
  EXPECT_GT(both, 30'000);
  EXPECT_GT(by_two, both * 95 / 100);
}

TEST(Disparity, PointsCarryHowFarTheirDepthIsKnown) {
  const Looked looked(test::crate_room());
  const auto map = match_disparity({}, looked.pair);
  ASSERT_TRUE(map);
  const std::vector<DepthPoint> points = points_of(*map, looked.rig, 4.0, 0.3, 2);
  ASSERT_GT(points.size(), 3000U);
  std::size_t within = 0;
  for (const DepthPoint& point : points) {
    const double z = point.in_camera.z();
    EXPECT_LE(z, 4.0 + 1e-6);
    EXPECT_NEAR(point.depth_sigma_m, z * z * 0.3 / (208.0 * 0.12), 1e-5);
    const double off = std::abs(z - looked.depth_m[static_cast<std::size_t>(point.pixel)]);
    within += off < 3.0 * point.depth_sigma_m ? 1 : 0;
  }
  EXPECT_GT(within, points.size() * 95 / 100);
}

TEST(Disparity, SettingsOutOfTheirBoundsAreNamed) {
  DisparityConfig config;
  EXPECT_TRUE(check(config));
  config.disparities = 50;
  EXPECT_THAT(check(config).error().message, testing::HasSubstr("disparities = 50"));
  config = {};
  config.large_penalty = 60;
  EXPECT_THAT(check(config).error().message, testing::HasSubstr("large_penalty = 60"));
  config = {};
  config.uniqueness = 0.9;
  EXPECT_THAT(check(config).error().message, testing::HasSubstr("uniqueness"));
}

}  // namespace
}  // namespace weft::agents
