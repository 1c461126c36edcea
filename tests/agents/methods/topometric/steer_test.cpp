#include <gtest/gtest.h>

#include <numbers>

#include "tests/agents/methods/topometric/steered_drive.hpp"

namespace weft::agents {
namespace {

constexpr double kFootprintM = 0.3;

/// Holds a site as it was taught, along x from 0 to 8 m, and its chart about x = 3 m.
struct Taught {
  explicit Taught(const MadeSite& site, const std::vector<std::size_t>& missing = {}) {
    Random random(21);
    TaughtSite taught;
    taught.teach_straight(site, {}, 8.0, random);
    chart.emplace(made_method().chart(taught.around(centre, missing)));
    site_from_chart = taught.site_from_places[centre];
  }
  static constexpr std::size_t centre = 6;
  std::optional<TopometricChart> chart;
  Pose2 site_from_chart;
};

/// Returns a hall of 12 by 5 m.
MadeSite empty_hall() {
  MadeSite site;
  site.add_box(-2.0, -2.5, 10.0, 2.5);
  return site;
}
MadeSite corridor() {
  MadeSite site;
  site.add_box(-2.0, -0.9, 10.0, 0.9);
  return site;
}
MadeSite with_crate(MadeSite site, double x0, double y0, double x1, double y1) {
  site.add_box(x0, y0, x1, y1);
  return site;
}

/// Returns a path along x with a pose each half metre, headings as it is driven.
std::vector<Pose2> path_along_x(double from, double to) {
  std::vector<Pose2> path;
  const double heading = to > from ? 0.0 : std::numbers::pi;
  const int hops = static_cast<int>(std::lround(std::abs(to - from) / 0.5));
  for (int i = 0; i <= hops; ++i) path.push_back({from + (to - from) * i / hops, 0.0, heading});
  return path;
}

TEST(TopometricSteer, DrivesToTheEndPrecisely) {
  const MadeSite site = corridor();
  const Taught taught(site);
  SteeredDrive drive(site, *taught.chart, taught.site_from_chart);
  const auto out = drive.along(path_along_x(0.0, 4.5), {0.1, 0.05, 0.1}, {});
  EXPECT_EQ(out.stopped, "");
  EXPECT_LE(out.off_m, 0.03);
  EXPECT_GT(out.least_room_m, kFootprintM);
  EXPECT_LT(out.took_s, 20.0);
}

TEST(TopometricSteer, KeepsTheSpeedLimit) {
  const MadeSite site = corridor();
  const Taught taught(site);
  SteeredDrive drive(site, *taught.chart, taught.site_from_chart);
  const auto out = drive.along(path_along_x(0.0, 4.5), {}, {.limit_m_s = 0.2});
  EXPECT_LE(out.fastest_m_s, 0.2 + 1e-9);
  EXPECT_LE(out.off_m, 0.03);
}

TEST(TopometricSteer, TurnsOnTheSpotWhereTheWayLeadsBack) {
  const MadeSite site = corridor();
  const Taught taught(site);
  SteeredDrive drive(site, *taught.chart, taught.site_from_chart);
  const auto out = drive.along(path_along_x(4.0, 1.0), {4.0, 0.0, 0.1}, {});
  EXPECT_GT(out.steered_first_rad, 2.4);
  EXPECT_EQ(out.stopped, "");
  EXPECT_LE(out.off_m, 0.03);
  EXPECT_GT(out.least_room_m, kFootprintM);
}

TEST(TopometricSteer, GoesRoundACrateThatOnlyItSees) {
  const Taught taught(empty_hall());
  const MadeSite now = with_crate(empty_hall(), 2.5, -0.3, 3.1, 0.3);
  SteeredDrive drive(now, *taught.chart, taught.site_from_chart);
  const auto out = drive.along(path_along_x(0.0, 5.0), {}, {});
  EXPECT_EQ(out.stopped, "");
  EXPECT_LE(out.off_m, 0.03);
  EXPECT_GT(out.least_room_m, kFootprintM - 0.06);
}

TEST(TopometricSteer, StaysInTheCorridorThatItHolds) {
  const Taught taught(empty_hall());
  const MadeSite now = with_crate(empty_hall(), 2.5, -0.3, 3.1, 0.3);
  SteeredDrive drive(now, *taught.chart, taught.site_from_chart);
  const auto wide = drive.along(path_along_x(0.0, 5.0), {}, {.aside_m = 1.0});
  EXPECT_EQ(wide.stopped, "");
  EXPECT_LE(wide.most_aside_m, 1.0);
  SteeredDrive narrow_drive(now, *taught.chart, taught.site_from_chart);
  const auto narrow = narrow_drive.along(path_along_x(0.0, 5.0), {}, {.aside_m = 0.3});
  EXPECT_EQ(narrow.stopped, "blocked");
  EXPECT_LE(narrow.most_aside_m, 0.3);
  EXPECT_LT(narrow.end.x, 2.5 - kFootprintM + 0.06);
}

TEST(TopometricSteer, StandsBlockedWhereACorridorIsClosed) {
  const Taught taught(corridor());
  const MadeSite now = with_crate(corridor(), 3.5, -0.9, 3.8, 0.9);
  SteeredDrive drive(now, *taught.chart, taught.site_from_chart);
  const auto out = drive.along(path_along_x(0.0, 5.0), {}, {.stops_for_s = 12.0});
  EXPECT_EQ(out.stopped, "blocked");
  EXPECT_GT(out.least_room_m, kFootprintM - 0.06);
  EXPECT_LT(out.end.x, 3.5 - 0.66) << "nearer than this its camera does not see the crate";
  EXPECT_GT(out.end.x, 2.0);
}

TEST(TopometricSteer, StandsWhenItHasDrivenInTheDarkForLong) {
  const MadeSite site = corridor();
  const Taught taught(site);
  SteeredDrive drive(site, *taught.chart, taught.site_from_chart);
  const auto out = drive.along(path_along_x(0.0, 5.0), {}, {.dark_from_s = 2.0});
  EXPECT_EQ(out.stopped, "blind");
  EXPECT_GT(out.end.x, 1.5) << "for a while it goes on";
  EXPECT_LT(out.end.x, 3.2);
}

TEST(TopometricSteer, DoesNotDriveWhereNoContentIsThere) {
  const MadeSite site = corridor();
  std::vector<std::size_t> all(17);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const Taught taught(site, all);
  SteeredDrive drive(site, *taught.chart, taught.site_from_chart);
  const auto out = drive.along(path_along_x(3.0, 6.0), {3.0, 0.0, 0.0}, {.for_s = 4.0});
  EXPECT_EQ(out.fastest_m_s, 0.0);
  EXPECT_EQ(out.stopped, "unknown");
  EXPECT_TRUE(out.has_been_pending);
}

TEST(TopometricSteer, ComesToStandWhereTheChartEnds) {
  // The places that have arrived do not see what lies beyond.
  std::vector<std::size_t> beyond;
  for (std::size_t i = 6; i < 17; ++i) beyond.push_back(i);
  const Taught taught(corridor(), beyond);
  const MadeSite now = corridor();
  SteeredDrive drive(now, *taught.chart, taught.site_from_chart);
  const auto out = drive.along(path_along_x(0.0, 10.0), {}, {});
  EXPECT_EQ(out.stopped, "unknown");
  EXPECT_TRUE(out.has_been_pending);
  EXPECT_NE(taught.chart->grid.at(taught.site_from_chart.inverse() * out.end.translation()), CellState::unknown);
}

TEST(TopometricSteer, LooksAroundAndDoesNotDriveWhereTheChartKnowsNoWay) {
  const MadeSite site = with_crate(corridor(), 4.0, -0.9, 4.2, 0.9);  // taught from both sides
  Random random(21);
  TaughtSite both_sides;
  both_sides.teach_straight(site, {}, 3.0, random);
  both_sides.teach_straight(site, {5.5, 0.0, 0.0}, 2.5, random);
  const TopometricChart chart = made_method().chart(both_sides.around(6));
  SteeredDrive drive(site, chart, both_sides.site_from_places[6]);
  const auto out = drive.along(path_along_x(0.0, 7.0), {}, {.for_s = 90.0, .stops_for_s = 8.0});
  EXPECT_EQ(out.stopped, "no_way");
  EXPECT_LT(out.end.x, 4.0 - kFootprintM + 0.06);
  EXPECT_FALSE(out.has_driven_lost);
  EXPECT_NEAR(out.turned_lost_rad, 4.0 * std::numbers::pi, 0.2);
}

TEST(TopometricSteer, AnswersAtTenHertzWhateverTheSamples) {
  const MadeSite site = corridor();
  const Taught taught(site);
  SteeredDrive drive(site, *taught.chart, taught.site_from_chart);
  Topometric::Odometry& odometry = drive.odometry();
  Ahead ahead;
  ahead.robot_from_path = path_along_x(0.0, 3.0);
  const TopometricBelief belief;
  const Around<Topometric> around{&*taught.chart, &belief, Pose2{-3.0, 0.0, 0.0}};
  const Steering first = drive.method().steer(odometry, &around, ahead);
  ASSERT_TRUE(first);
  odometry.time += from_seconds(0.033);
  ahead.robot_from_path = {Pose2{}};  // would be there
  EXPECT_EQ(*drive.method().steer(odometry, &around, ahead), *first);
  odometry.time += from_seconds(0.07);
  EXPECT_NE(*drive.method().steer(odometry, &around, ahead), *first);
}

TEST(TopometricSteer, StopsWithoutAChart) {
  Topometric::Odometry odometry;
  Ahead ahead;
  ahead.robot_from_path = path_along_x(0.0, 3.0);
  const Steering steering = made_method().steer(odometry, nullptr, ahead);
  ASSERT_FALSE(steering);
  EXPECT_EQ(steering.error().reason, "no_chart");
}

TEST(TopometricRecover, TurnsOnTheSpotTwiceAtMostAndNeverDrives) {
  const Topometric method = made_method();
  Topometric::Odometry odometry;
  odometry.costmap.emplace(CostmapConfig{});
  odometry.time = SensorTime{from_seconds(1.0)};
  Scan scan;
  scan.beams.push_back({0.0, 1.02, 0.01, 1.02, Beam::Return::obstacle});
  odometry.costmap->take({}, scan, odometry.time);
  LostFor lost;
  double turned = 0.0;
  std::optional<Twist> command = Twist{};
  for (int i = 0; i < 1000 && command; ++i) {
    command = method.recover(odometry, lost);
    if (!command) break;
    EXPECT_EQ(command->linear_m_s, 0.0);
    turned += std::abs(command->angular_rad_s) * 0.1;
    lost.turned_rad = turned;
    lost.time += from_seconds(0.1);
    odometry.time += from_seconds(0.1);
    if (i == 0) {
      const OccupancyGrid seen = odometry.costmap->grid(odometry.time);
      for (const CellState state : seen.cells) ASSERT_EQ(state, CellState::unknown) << "the costmap is cleared";
    }
  }
  EXPECT_FALSE(command);
  EXPECT_GT(turned, 4.0 * std::numbers::pi - 0.1);
  EXPECT_LT(turned, 4.0 * std::numbers::pi + 0.2);
}

TEST(TopometricRecover, ClearsTheCostmapOnce) {
  const Topometric method = made_method();
  Topometric::Odometry odometry;
  odometry.costmap.emplace(CostmapConfig{});
  odometry.time = SensorTime{from_seconds(1.0)};
  method.recover(odometry, {});
  Scan scan;
  scan.beams.push_back({0.0, 1.02, 0.01, 1.02, Beam::Return::obstacle});
  odometry.costmap->take({}, scan, odometry.time);
  method.recover(odometry, {});
  EXPECT_EQ(odometry.costmap->grid(odometry.time).at(Eigen::Vector2d(1.02, 0.01)), CellState::occupied);
}

TEST(TopometricClear, AStraightWayThroughAHallIsClear) {
  const MadeSite site = empty_hall();
  const Taught taught(site);
  EXPECT_TRUE(made_method().is_clear(*taught.chart, {-1.0, 0.0, 0.0}, {3.0, 0.8, 0.0}));
}

TEST(TopometricClear, AWayThroughACrateOrTooNearToItIsNot) {
  const Taught taught(with_crate(empty_hall(), 4.0, 0.6, 4.6, 1.2));
  const Topometric method = made_method();
  EXPECT_FALSE(method.is_clear(*taught.chart, {-1.0, 0.9, 0.0}, {3.5, 0.0, 0.0}));
  EXPECT_FALSE(method.is_clear(*taught.chart, {-1.0, 0.45, 0.0}, {3.5, 0.0, 0.0})) << "too narrow for its footprint";
  EXPECT_TRUE(method.is_clear(*taught.chart, {-1.0, 0.1, 0.0}, {3.5, 0.0, 0.0}));
}

TEST(TopometricClear, AWayThatNobodyHasSeenIsNot) {
  const Taught taught(empty_hall());
  EXPECT_FALSE(made_method().is_clear(*taught.chart, {0.0, 0.0, 0.0}, {9.0, 0.0, 0.0})) << "beyond the wall";
  EXPECT_FALSE(made_method().is_clear(*taught.chart, {-3.0, 0.0, 0.0}, {0.0, 1.5, 0.0})) << "beside the first place";
}

}  // namespace
}  // namespace weft::agents
