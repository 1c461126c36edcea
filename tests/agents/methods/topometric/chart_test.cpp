#include "agents/methods/topometric/chart.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "agents/methods/topometric/free_space.hpp"
#include "tests/agents/methods/topometric/made_site.hpp"

namespace weft::agents {
namespace {

TopometricChart room_chart(const std::vector<std::size_t>& missing = {}) {
  Random random(3);
  const MadeSite site = furnished_room();
  TaughtSite taught;
  taught.teach_straight(site, {}, 5.0, random);
  return made_method().chart(taught.around(4, missing));
}

/// Returns a point of the room in the chart about its fifth place.
Eigen::Vector2d in_chart(double x, double y) {
  return {x - 2.0, y};
}

TEST(TopometricChart, ShowsWallsAndFreeFloor) {
  const TopometricChart chart = room_chart();
  EXPECT_EQ(chart.grid.at(in_chart(4.0, 0.0)), CellState::free);
  EXPECT_EQ(chart.grid.at(in_chart(5.0, 1.0)), CellState::free);
  int walls = 0;
  for (double y = -1.0; y < 1.0; y += 0.05) {
    for (const double x : {7.925, 7.975, 8.025, 8.075})
      if (chart.grid.at(in_chart(x, y)) == CellState::occupied) {
        ++walls;
        break;
      }
  }
  EXPECT_GE(walls, 36) << "of 40 stretches of the wall ahead";
  EXPECT_NE(chart.grid.at(in_chart(6.4, 1.6)), CellState::free) << "nobody sees through the pillar";
  EXPECT_EQ(chart.grid.at(in_chart(9.0, 0.0)), CellState::unknown);
}

TEST(TopometricChart, DoesNotCastWhatWasSeenFromTooFar) {
  TopometricConfig config;
  config.chart.seen_within_m = 2.0;
  Random random(3);
  TaughtSite taught;
  taught.teach_straight(furnished_room(), {}, 5.0, random);
  const TopometricChart chart = made_method(config).chart(taught.around(4));
  for (double y = -1.0; y < 1.0; y += 0.05)
    EXPECT_NE(chart.grid.at(in_chart(8.0, y)), CellState::occupied) << "it is 3 m from the last place";
  EXPECT_EQ(chart.grid.at(in_chart(4.0, 0.0)), CellState::free);
}

TEST(TopometricChart, FreesWhatItsTeachersDroveOver) {
  const TopometricChart chart = room_chart();
  EXPECT_EQ(chart.grid.at(in_chart(0.0, 0.0)), CellState::free) << "no camera saw the floor under the first place";
  EXPECT_EQ(chart.grid.at(in_chart(0.0, 0.35)), CellState::free);
  EXPECT_EQ(chart.grid.at(in_chart(-0.95, -2.0)), CellState::unknown);
}

TEST(TopometricChart, KnowsNothingOfPlacesWithoutContent) {
  const TopometricChart chart = room_chart({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  for (const CellState state : chart.grid.cells) ASSERT_EQ(state, CellState::unknown);
  EXPECT_EQ(chart.places->size(), 11U);
  EXPECT_FALSE(chart.anywhere_free());
}

TEST(TopometricChart, RaysBeginAtTheCamerasNotAtThePlace) {
  // A place behind a pillar whose frames saw it from before: with rays from the place the pillar would be passed.
  MadeSite site;
  site.walls.push_back({{-3.0, 4.0}, {6.0, 4.0}});
  site.add_box(1.5, -0.2, 1.9, 0.2);
  Random random(5);
  TopometricContent content = site.content_at({}, random);
  const Pose2 moved{3.0, 0.0, 0.0};  // the place is taken to be here; its frames are where they were
  for (Eigen::Vector3f& point : content.cloud.points) point.x() -= 3.0F;
  for (Eigen::Vector3f& camera : content.cloud.cameras) camera.x() -= 3.0F;
  for (Pose3& frame : content.cloud.place_from_frames) frame.translation.x() -= 3.0;
  const TopometricChart chart = made_method().chart(
      {{TaughtSite::id(0), 0, Metric3{}, std::make_shared<const TopometricContent>(std::move(content))}});
  const auto at = [&](double x, double y) {
    return chart.grid.at(Eigen::Vector2d(moved.inverse() * Eigen::Vector2d(x, y)));
  };
  int face = 0;
  for (double y = -0.175; y < 0.2; y += 0.05)
    if (at(1.475, y) == CellState::occupied || at(1.525, y) == CellState::occupied) ++face;
  EXPECT_GE(face, 6);
  EXPECT_EQ(at(2.3, 0.0), CellState::unknown) << "it lies in the pillar's shadow";
}

TEST(TopometricChart, ClearBearingsFreeWhatLiesBetweenCameraAndRange) {
  TopometricContent content;  // a place whose frames saw no point within range
  content.rig = {320, 240, 208.0, 159.5, 119.5, 0.12, {}};
  content.rig.robot_from_camera.rotation =
      Eigen::Quaterniond(Eigen::Matrix3d{{0.0, 0.0, 1.0}, {-1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}});
  content.rig.robot_from_camera.translation = {0.15, 0.06, 0.45};
  content.clear_m = 5.0F;
  Scan scan;  // clear to the left of straight ahead, but for what stands 0.4 rad to the left
  for (double bearing = -0.65; bearing < 0.65; bearing += 0.0087266) {
    const bool stands = bearing < 0.0 || std::abs(bearing - 0.4) < 0.02;
    scan.beams.push_back(
        {bearing, 2.0, 0.04, stands ? 2.0 : 5.0, stands ? Beam::Return::obstacle : Beam::Return::none});
  }
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d moved(-0.01 * i, 0.007 * i, 0.0);
    content.cloud.place_from_frames.emplace_back().translation = moved;
    content.cloud.cameras.push_back((moved + content.rig.robot_from_camera.translation).cast<float>());
    content.cloud.clear_bearings.push_back(clear_bearings(scan, content.rig, 5.0));
  }
  const auto grid_of = [&] {
    TopometricChartConfig config;
    config.driven_m = 0.0;
    return chart_places(config, {}, {},
                        {{TaughtSite::id(0), 0, Metric3{}, std::make_shared<const TopometricContent>(content)}})
        .grid;
  };
  const OccupancyGrid grid = grid_of();
  const auto at = [&](double away_m, double bearing) {
    return grid.at(Eigen::Vector2d(0.15 + away_m * std::cos(bearing), 0.06 + away_m * std::sin(bearing)));
  };
  for (const double bearing : {0.05, 0.2, 0.33, 0.5, 0.6})
    for (double away_m = 0.5; away_m < 4.9; away_m += 0.1)
      ASSERT_EQ(at(away_m, bearing), CellState::free) << away_m << " m at " << bearing;
  EXPECT_EQ(at(2.5, -0.1), CellState::unknown);
  EXPECT_EQ(at(4.0, 0.4), CellState::unknown);
  EXPECT_EQ(at(5.3, 0.2), CellState::unknown);

  content.cloud.clear_bearings.clear();
  for (const CellState state : grid_of().cells) ASSERT_EQ(state, CellState::unknown);
}

TEST(TopometricChart, DrawsFreeCells) {
  const TopometricChart chart = room_chart();
  const DrawPose anywhere = chart.anywhere_free();
  ASSERT_TRUE(anywhere);
  Random random(1);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(chart.grid.at(anywhere(random).translation()), CellState::free);
}

}  // namespace
}  // namespace weft::agents
