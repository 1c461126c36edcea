#include "agents/perception/clouds/pcl_check.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "agents/perception/clouds/moved.hpp"
#include "tests/agents/perception/clouds/scanned_corner.hpp"

namespace weft::agents::pcl_check {
namespace {

TEST(PclCheck, MeasuresRollPitchAndHeightOfTheFloorBelow) {
  const Pose3 level_from_robot{Eigen::Quaterniond(Eigen::AngleAxisd(0.03, Eigen::Vector3d(0.6, 0.8, 0.0))),
                               {0.0, 0.0, 0.4}};
  const std::vector<Eigen::Vector3f> points = moved(test::scanned(1, true), level_from_robot.inverse());
  const auto floor = find_floor(points, {});
  ASSERT_TRUE(floor);
  EXPECT_GT(floor->points, 3500U);
  const Pose3 found = floor->level_from_frame();
  EXPECT_LT((found.rotation * level_from_robot.rotation.inverse()).angularDistance(Eigen::Quaterniond::Identity()),
            0.002);
  EXPECT_NEAR(found.translation.z(), 0.4, 0.003);
}

TEST(PclCheck, AWallIsNoFloorNorAreFewPoints) {
  Random random(4);
  std::vector<Eigen::Vector3f> wall;
  for (int at = 0; at < 2000; ++at) {
    wall.emplace_back(static_cast<float>(random.uniform(0.0, 4.0)), 1.0F,
                      static_cast<float>(random.uniform(0.0, 2.0)));
  }
  EXPECT_FALSE(find_floor(wall, {}));
  const std::vector<Eigen::Vector3f> floor = test::scanned(1, false);
  EXPECT_FALSE(find_floor(std::span(floor).first(30), {}));
  EXPECT_FALSE(find_floor({}, {}));
}

TEST(PclCheck, VoxelsHaveOneMeanEach) {
  const std::vector<Eigen::Vector3f> points = {{0.01F, 0.01F, 0.01F}, {0.03F, 0.03F, 0.03F}, {0.11F, 0.0F, 0.0F}};
  const auto means = voxel_grid(points, 0.1);
  ASSERT_TRUE(means);
  ASSERT_EQ(means->size(), 2U);
  EXPECT_LT(((*means)[0] - Eigen::Vector3f(0.02F, 0.02F, 0.02F)).norm(), 1e-6F);
  EXPECT_TRUE(voxel_grid({}, 0.1)->empty());
}

TEST(PclCheck, MoreVoxelsThanPclCanNumberAreRefused) {
  const std::vector<Eigen::Vector3f> points = {{0.0F, 0.0F, 0.0F}, {9000.0F, 9000.0F, 9000.0F}};
  const auto refused = voxel_grid(points, 0.001);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalid);
}

TEST(PclCheck, PointsAloneAreLeftOutAndTheOthersKeepTheirIndices) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Eigen::Vector3f> points = {
      {none, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F}, {0.01F, 0.0F, 0.0F}, {0.0F, 0.01F, 0.0F}};
  EXPECT_EQ(with_neighbours(points, 0.05, 2), (std::vector<std::uint32_t>{1, 3, 4}));
}

TEST(PclCheck, BothRegistrationsFindThePoseOfARoom) {
  const Pose3 truth = lift({0.3, -0.1, 0.05});
  const std::vector<Eigen::Vector3f> a = voxel_grid(test::scanned(1, true), 0.1).value();
  const std::vector<Eigen::Vector3f> b = voxel_grid(moved(test::scanned(2, true), truth.inverse()), 0.1).value();
  const Pose3 guess = truth * lift({0.05, 0.05, 0.01});
  for (const Opinion& opinion : {register_p2d_ndt(a, b, guess, 1.0), register_gicp(a, b, guess, 0.5)}) {
    EXPECT_TRUE(opinion.has_converged);
    EXPECT_LT((truth.inverse() * opinion.a_from_b).translation.norm(), 0.03);
    EXPECT_LT(opinion.fitness_m2, 0.01);
  }
}

TEST(PclCheck, NothingRegistersToNothing) {
  const std::vector<Eigen::Vector3f> a = test::scanned(1, true);
  EXPECT_FALSE(register_p2d_ndt(a, {}, {}, 1.0).has_converged);
  EXPECT_FALSE(register_gicp({}, a, {}, 0.5).has_converged);
}

}  // namespace
}  // namespace weft::agents::pcl_check
