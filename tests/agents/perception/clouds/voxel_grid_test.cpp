#include "agents/perception/clouds/voxel_grid.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "agents/perception/clouds/moved.hpp"

namespace weft::agents {
namespace {

TEST(VoxelGrid, KeepsTheMeanOfEachCube) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Eigen::Vector3f> points = {
      {0.01F, 0.01F, 0.01F}, {-0.01F, 0.0F, 0.0F}, {none, 0.0F, 0.0F}, {0.03F, 0.03F, 0.03F}};
  const auto means = voxel_means(points, 0.05);
  ASSERT_EQ(means.size(), 2U);
  EXPECT_TRUE(means[0].isApprox(Eigen::Vector3f(0.02F, 0.02F, 0.02F), 1e-5F));
  EXPECT_TRUE(means[1].isApprox(points[1], 1e-5F));
}

TEST(Moved, TakesPointsToTheOtherFrame) {
  const Pose3 a_from_b = lift({1.0, 2.0, 0.5 * std::numbers::pi});
  const std::vector<Eigen::Vector3f> points = {{1.0F, 0.0F, 3.0F}};
  EXPECT_LT((moved(points, a_from_b)[0] - Eigen::Vector3f(1.0F, 3.0F, 3.0F)).norm(), 1e-6F);
}

}  // namespace
}  // namespace weft::agents
