#include "agents/perception/clouds/ndt_map.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "tests/agents/perception/clouds/scanned_corner.hpp"

namespace weft::agents {
namespace {

/// Returns a patch of a wall across x, 2 m ahead of a camera at the origin, that fills one cell of 0.2 m.
std::vector<Eigen::Vector3f> wall_patch(std::uint64_t seed) {
  Random random(seed);
  std::vector<Eigen::Vector3f> points;
  for (int at = 0; at < 400; ++at) {
    points.emplace_back(
        Eigen::Vector3d(2.1 + random.normal(0.0, 0.004), random.uniform(0.0, 0.2), random.uniform(0.1, 0.3))
            .cast<float>());
  }
  return points;
}

double sigma_along(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& direction) {
  return std::sqrt(direction.dot(covariance * direction));
}

TEST(NdtMap, ACellIsThinAcrossItsSurface) {
  const std::vector<Eigen::Vector3f> points = wall_patch(1);
  const NdtMap map = ndt_map({points}, NdtCellConfig{});
  ASSERT_EQ(map.levels.front().cells.size(), 1U);
  const NdtCell& cell = map.levels.front().cells[0];
  EXPECT_NEAR(cell.mean.x(), 2.1, 0.002);
  EXPECT_GT(std::abs(cell.normal.x()), 0.99);
  EXPECT_NEAR(sigma_along(cell.covariance, Eigen::Vector3d::UnitX()), NdtCellConfig{}.least_sigma_m, 1e-3);
  EXPECT_NEAR(sigma_along(cell.covariance, Eigen::Vector3d::UnitY()), 0.2 / std::sqrt(12.0), 0.005);
  EXPECT_GE(std::sqrt(cell.across), NdtCellConfig{}.least_sigma_m);
  EXPECT_LT(std::sqrt(cell.across), 0.03);
  EXPECT_NEAR(std::sqrt(cell.mean_covariance(1, 1)), 0.2 / std::sqrt(12.0 * 400.0), 0.001);
}

TEST(NdtMap, DepthNoiseWidensACellAlongItsRayAlone) {
  const std::vector<Eigen::Vector3f> points = wall_patch(1);
  const std::vector<std::uint16_t> frames(points.size(), 0);
  const DepthNoise noise{300.0, 0.12, 0.5};  // 6 cm at 2.1 m
  const std::vector<Eigen::Vector3f> before = {{0.1F, 0.1F, 0.2F}};
  const NdtCell seen = ndt_map({points, frames, before, noise}, NdtCellConfig{}).levels[0].cells.at(0);
  EXPECT_NEAR(sigma_along(seen.covariance, Eigen::Vector3d::UnitX()), noise.sigma_m(2.0), 0.02);
  const std::vector<Eigen::Vector3f> beside = {{2.1F, -1.9F, 0.2F}};
  const NdtCell grazed = ndt_map({points, frames, beside, noise}, NdtCellConfig{}).levels[0].cells.at(0);
  EXPECT_LT(sigma_along(grazed.covariance, Eigen::Vector3d::UnitX()), 0.03);
}

TEST(NdtMap, DepthNoiseDoesNotTurnTheNormalOfAWallSeenAtASlant) {
  const std::vector<Eigen::Vector3f> points = wall_patch(1);
  const std::vector<std::uint16_t> frames(points.size(), 0);
  const std::vector<Eigen::Vector3f> aside = {{1.5F, -1.9F, 0.2F}};
  const NdtCell cell = ndt_map({points, frames, aside, {300.0, 0.12, 0.8}}, NdtCellConfig{}).levels[0].cells.at(0);
  EXPECT_GT(std::abs(cell.normal.x()), 0.999);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(cell.covariance);
  EXPECT_LT(std::abs(axes.eigenvectors()(0, 0)), 0.99) << "the widened spread leans";
}

TEST(NdtMap, LargerCellsHoldThePointsOfTheSmallerOnes) {
  const std::vector<Eigen::Vector3f> points = test::scanned(3, true);
  const NdtMap map = ndt_map({points}, NdtCellConfig{});
  ASSERT_GE(map.levels.size(), 3U);
  for (std::size_t level = 1; level < 3; ++level) {
    EXPECT_EQ(map.levels[level].cell_m, 2.0 * map.levels[level - 1].cell_m);
    EXPECT_LT(map.levels[level].cells.size(), map.levels[level - 1].cells.size());
    EXPECT_EQ(map.levels[level].table.size(), map.levels[level].cells.size());
  }
}

TEST(NdtMap, ASparseCloudBeginsWithLargerCells) {
  std::vector<Eigen::Vector3f> points = test::scanned(3, true);
  points.resize(600);
  EXPECT_GT(ndt_map({points}, NdtCellConfig{}).levels.front().cell_m, 0.2);
}

TEST(NdtMap, ALineOfPointsSaysLittleAcrossIt) {
  Random random(5);
  std::vector<Eigen::Vector3f> points;  // one line of a laser over a wall
  for (int at = 0; at < 60; ++at) {
    points.emplace_back(static_cast<float>(random.normal(2.1, 0.01)), static_cast<float>(random.uniform(0.0, 0.2)),
                        static_cast<float>(random.normal(0.2, 0.01)));
  }
  const NdtCell line = ndt_map({points}, NdtCellConfig{}).levels[0].cells.at(0);
  EXPECT_GT(std::sqrt(line.across), 0.03);
}

TEST(NdtMap, WherePointsAreTooFewForSmallCellsLargerOnesAreTheFinest) {
  std::vector<Eigen::Vector3f> points = wall_patch(1);
  Random random(2);
  for (int at = 0; at < 12; ++at) {  // a thin sheet of points, 3 m beside
    points.emplace_back(Eigen::Vector3d(random.uniform(2.0, 2.8), 3.21, random.uniform(0.0, 0.7)).cast<float>());
  }
  const NdtMap map = ndt_map({points}, NdtCellConfig{});
  const auto finest_at = [&](std::size_t level, double y) {
    const auto& cells = map.levels.at(level).cells;
    return std::count_if(cells.begin(), cells.end(),
                         [&](const NdtCell& cell) { return cell.is_finest && std::abs(cell.mean.y() - y) < 0.3; });
  };
  EXPECT_EQ(finest_at(0, 0.1), 1) << "the patch fills a cell";
  EXPECT_EQ(finest_at(1, 0.1), 0) << "which holds all of the larger one's points";
  EXPECT_EQ(finest_at(0, 3.2), 0);
  EXPECT_GE(finest_at(1, 3.2) + finest_at(2, 3.2), 1);
}

TEST(NdtMap, WithoutPointsThereIsNoCell) {
  for (const NdtLevel& level : ndt_map({}, NdtCellConfig{}).levels) EXPECT_TRUE(level.cells.empty());
}

}  // namespace
}  // namespace weft::agents
