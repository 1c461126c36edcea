#include "agents/control/grid/ray_cast.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace weft::agents {
namespace {

const Raster kTenMetres = square_raster({0.0, 0.0}, 10.0, 0.05);

SeenCloud from_one_camera(const Eigen::Vector3f& camera) {
  return {{}, {camera}};
}

/// Sees a point several times, as several voxels of one column are.
void see(SeenCloud& cloud, float x, float y, float z, std::uint16_t frame = 0, int times = 4) {
  for (int i = 0; i < times; ++i) cloud.points.push_back({{x, y, z}, frame});
}

OccupancyGrid grid_of(const SeenCloud& cloud, const RayCastConfig& config = {}) {
  RayCaster caster(kTenMetres, config);
  EXPECT_TRUE(caster.cast(cloud));
  return caster.grid();
}

TEST(RayLines, LeadToEachCellOfTheRingAndNearAllWithin) {
  const RayLines lines(20);
  for (int column = -20; column <= 20; ++column) {
    for (int row = -20; row <= 20; ++row) {
      const CellOffset to{column, row};
      const int steps = RayLines::steps_to(to);
      const CellOffset met = RayLines::Walk(lines, lines.line_to(to)).at(steps);
      ASSERT_LE(std::abs(met.columns - column) + std::abs(met.rows - row), steps == 20 ? 0 : 1)
          << column << ", " << row;
    }
  }
}

TEST(RayCast, ARayPassesWhatIsBeforeItsEndAndNothingBehind) {
  SeenCloud cloud = from_one_camera({0.025F, 0.025F, 0.6F});
  see(cloud, 2.025F, 0.025F, 0.6F);
  const OccupancyGrid grid = grid_of(cloud);
  EXPECT_EQ(grid.at(Eigen::Vector2d(0.025, 0.025)), CellState::free);
  EXPECT_EQ(grid.at(Eigen::Vector2d(1.0, 0.025)), CellState::free);
  EXPECT_EQ(grid.at(Eigen::Vector2d(1.975, 0.025)), CellState::free);
  EXPECT_EQ(grid.at(Eigen::Vector2d(2.025, 0.025)), CellState::occupied);
  EXPECT_EQ(grid.at(Eigen::Vector2d(2.075, 0.025)), CellState::unknown);
  EXPECT_EQ(grid.at(Eigen::Vector2d(1.0, 0.525)), CellState::unknown);
}

TEST(RayCast, FewRaysLeaveACellUnknown) {
  SeenCloud cloud = from_one_camera({0.025F, 0.025F, 0.6F});
  see(cloud, 2.025F, 0.025F, 0.6F, 0, 2);
  EXPECT_EQ(grid_of(cloud).at(Eigen::Vector2d(2.025, 0.025)), CellState::unknown);
  RayCastConfig two;
  two.n_min = 2;
  EXPECT_EQ(grid_of(cloud, two).at(Eigen::Vector2d(2.025, 0.025)), CellState::occupied);
}

TEST(RayCast, AShareOfTauThatEndsIsNeeded) {
  SeenCloud cloud = from_one_camera({0.025F, 0.025F, 0.6F});
  see(cloud, 2.025F, 0.025F, 0.6F, 0, 2);
  see(cloud, 3.025F, 0.025F, 0.6F, 0, 8);
  EXPECT_EQ(grid_of(cloud).at(Eigen::Vector2d(2.025, 0.025)), CellState::free) << "8 of 10 rays passed";
  RayCastConfig fifth;
  fifth.tau = 0.2;
  EXPECT_EQ(grid_of(cloud, fifth).at(Eigen::Vector2d(2.025, 0.025)), CellState::occupied);
}

TEST(RayCast, FloorIsPassedAndWhatHangsHighSaysNothing) {
  SeenCloud cloud = from_one_camera({0.025F, 0.025F, 0.6F});
  see(cloud, 1.025F, 0.025F, 0.02F);
  see(cloud, 0.025F, 1.025F, 1.9F);
  const OccupancyGrid grid = grid_of(cloud);
  EXPECT_EQ(grid.at(Eigen::Vector2d(1.025, 0.025)), CellState::free);
  EXPECT_EQ(grid.at(Eigen::Vector2d(0.025, 1.025)), CellState::unknown);
  EXPECT_EQ(grid.at(Eigen::Vector2d(0.025, 0.5)), CellState::unknown) << "a beam overhead frees no floor";
}

TEST(RayCast, APointBelowTheFloorFreesNothingOnTheWayToIt) {
  SeenCloud cloud = from_one_camera({0.025F, 0.025F, 0.6F});
  see(cloud, 2.025F, 0.025F, -0.4F);
  const OccupancyGrid grid = grid_of(cloud);
  EXPECT_EQ(grid.at(Eigen::Vector2d(1.0, 0.025)), CellState::unknown);
  EXPECT_EQ(grid.at(Eigen::Vector2d(2.025, 0.025)), CellState::occupied);
}

TEST(RayCast, RaysLongerThanTheRangeInSpaceAreDiscarded) {
  RayCastConfig config;
  config.range_m = 2.0;
  SeenCloud cloud = from_one_camera({0.025F, 0.025F, 1.5F});
  see(cloud, 1.825F, 0.025F, 0.3F);  // 1.8 m away on the floor, 2.2 in space
  EXPECT_EQ(grid_of(cloud, config).at(Eigen::Vector2d(1.0, 0.025)), CellState::unknown);
  config.range_m = 2.3;
  EXPECT_EQ(grid_of(cloud, config).at(Eigen::Vector2d(1.0, 0.025)), CellState::free);
}

/// Sees what stands around a pillar of 0.4 m, at (0, 0), on a circle of 2 m: from two cameras that each see the wall
/// on their own side alone.
SeenCloud around_a_pillar() {
  SeenCloud cloud{{}, {{-1.5F, 0.0F, 0.6F}, {1.5F, 0.0F, 0.6F}}};
  for (int degree = 0; degree < 360; ++degree) {
    const double angle = degree * std::numbers::pi / 180.0;
    const auto x = static_cast<float>(2.0 * std::cos(angle));
    const auto y = static_cast<float>(2.0 * std::sin(angle));
    const std::uint16_t frame = x < 0.0F ? 0 : 1;
    see(cloud, x, y, 0.6F, frame);
    if (std::abs(y) <= 1.0F) see(cloud, 0.105F * x, 0.105F * y, 0.6F, frame);
  }
  return cloud;
}

TEST(RayCast, APillarSeenFromTwoViewpointsStandsWhereItIs) {
  const OccupancyGrid grid = grid_of(around_a_pillar());
  EXPECT_EQ(grid.at(Eigen::Vector2d(-0.225, 0.025)), CellState::occupied);
  EXPECT_EQ(grid.at(Eigen::Vector2d(0.225, 0.025)), CellState::occupied);
  EXPECT_EQ(grid.at(Eigen::Vector2d(-1.0, 0.0)), CellState::free);
  EXPECT_EQ(grid.at(Eigen::Vector2d(1.0, 0.0)), CellState::free);
  EXPECT_EQ(grid.at(Eigen::Vector2d(0.0, 0.0)), CellState::unknown) << "no ray goes through the pillar";
}

TEST(RayCast, RaysBeginAtTheCameraOfTheFrameThatSawThePoint) {
  SeenCloud wrong = around_a_pillar();
  wrong.cameras[1] = wrong.cameras[0];
  EXPECT_EQ(grid_of(wrong).at(Eigen::Vector2d(0.0, 0.0)), CellState::free)
      << "from one camera for all, the far side seems to be seen through the pillar";
}

TEST(RayCast, APointOfAFrameWithoutACameraIsRefusedByName) {
  SeenCloud cloud = from_one_camera({0.0F, 0.0F, 0.6F});
  see(cloud, 1.0F, 0.0F, 0.6F, 0, 3);
  see(cloud, 1.0F, 0.0F, 0.6F, 7, 1);
  RayCaster caster(kTenMetres, {});
  const Result<void> cast = caster.cast(cloud);
  ASSERT_FALSE(cast);
  EXPECT_EQ(cast.error().code, ErrorCode::invalid);
  EXPECT_EQ(cast.error().message,
            "ray_cast: point 3 is of frame 7, but the cloud has 1 camera positions; give one a frame");
  EXPECT_EQ(caster.grid().at(Eigen::Vector2d(0.5, 0.0)), CellState::unknown) << "none of it was counted";
}

TEST(RayCast, PointsThatAreNotFiniteOrOutsideDoNoHarm) {
  SeenCloud cloud = from_one_camera({4.9F, 0.025F, 0.6F});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  see(cloud, nan, 0.0F, 0.6F);
  see(cloud, 1.0F, 0.0F, nan);
  see(cloud, 6.9F, 0.025F, 0.6F);
  const OccupancyGrid grid = grid_of(cloud);
  EXPECT_EQ(grid.at(Eigen::Vector2d(4.975, 0.025)), CellState::free);
  EXPECT_EQ(grid.at(Eigen::Vector2d(6.9, 0.025)), CellState::unknown);
  EXPECT_EQ(grid.at(Eigen::Vector2d(2.0, 0.025)), CellState::unknown);
}

TEST(RayCast, SettingsOutOfBoundsAreNamedTogether) {
  RayCastConfig config;
  EXPECT_TRUE(check(config).empty());
  config.n_min = 0;
  config.tau = 1.5;
  const std::vector<Error> issues = check(config);
  ASSERT_EQ(issues.size(), 2U);
  EXPECT_NE(issues[0].message.find("ray_cast: n_min is 0"), std::string::npos) << issues[0].message;
  EXPECT_NE(issues[1].message.find("tau is 1.5"), std::string::npos) << issues[1].message;
}

}  // namespace
}  // namespace weft::agents
