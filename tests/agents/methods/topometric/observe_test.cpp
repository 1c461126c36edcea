// Looks through the simulated pair: what the method sees must be what the site says stands there.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

#include "agents/methods/topometric/sight.hpp"
#include "tests/agents/methods/topometric/sim_drive.hpp"

namespace weft::agents {
namespace {

using namespace std::chrono_literals;

const Pose2 kStart{2.0, 1.8, 0.0};

sim::Site hall() {
  return test::topometric_site("hall");
}

/// Returns how far it is from a point to the nearest face of a wall, rack or pillar.
double off_m(const sim::Site& site, const Eigen::Vector2d& in_site) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const sim::Box& box : site.boxes)
    nearest = std::min(nearest, std::abs(distance_to(box, in_site.x(), in_site.y())));
  return nearest;
}

TEST(TopometricObserve, FollowsTheRobotWithinCentimetres) {
  test::SimDrive drive(hall(), kStart);
  drive.drive(1.5);
  drive.turn(0.5);
  const Pose2 seen = project(drive.odometry().odometry_from_robot);
  const Pose2 off = (kStart.inverse() * drive.truth()).inverse() * seen;
  EXPECT_LT(off.translation().norm(), 0.04);
  EXPECT_LT(std::abs(off.heading), 0.015);
  EXPECT_TRUE(drive.odometry().has_seen);
  EXPECT_EQ(drive.odometry().blind_m, 0.0);
}

TEST(TopometricObserve, ScansWhatStandsThereWhereItStands) {
  const sim::Site site = hall();
  test::SimDrive drive(site, {10.0, 1.0, 0.2});
  drive.drive(0.3);
  ASSERT_TRUE(drive.odometry().scan);
  const Scan& scan = *drive.odometry().scan;
  EXPECT_GT(scan.clear_from_m, 0.4) << "nearer nothing can be matched";
  EXPECT_LT(scan.clear_from_m, 1.0);
  double left_m = 0.0;
  double right_m = 0.0;
  for (const Beam& beam : scan.beams) {
    if (beam.bearing_rad > 0.58) left_m = std::max(left_m, beam.clear_m);
    if (beam.bearing_rad < -0.58) right_m = std::max(right_m, beam.clear_m);
  }
  EXPECT_EQ(left_m, 0.0) << "what is near there is not in the right image";
  EXPECT_GT(right_m, 0.5);
  std::vector<double> off;
  for (const Beam& beam : scan.beams) {
    if (beam.kind != Beam::Return::obstacle) continue;
    const Eigen::Vector2d end(beam.range_m * std::cos(beam.bearing_rad), beam.range_m * std::sin(beam.bearing_rad));
    const Eigen::Vector2d in_site = drive.truth() * (scan.robot_from_scan * end);
    off.push_back(off_m(site, in_site) / std::max(0.03, beam.sigma_m));
  }
  ASSERT_GT(off.size(), 40U);
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() / 2], 1.5) << "sigmas";
  EXPECT_LT(off[off.size() * 9 / 10], 4.0);
}

TEST(TopometricObserve, MarksTheCostmapInThePlaneOfItsOdometry) {
  const sim::Site site = hall();
  const Pose2 start{10.0, 1.0, 0.2};
  test::SimDrive drive(site, start);
  drive.drive(0.3);
  ASSERT_TRUE(drive.odometry().costmap);
  const OccupancyGrid grid = drive.odometry().costmap->grid(drive.odometry().time);
  int occupied = 0;
  int wrong = 0;
  for (int row = 0; row < grid.raster.rows; ++row)
    for (int column = 0; column < grid.raster.columns; ++column) {
      if (grid.at(Cell{column, row}) != CellState::occupied) continue;
      ++occupied;
      if (off_m(site, start * grid.raster.centre({column, row})) > 0.4) ++wrong;
    }
  EXPECT_GT(occupied, 20);
  EXPECT_LT(wrong, 1 + occupied / 10);
}

/// Has the method of a drive see its newest pair once more, changed.
class Blinded {
 public:
  Blinded(const test::SimDrive& drive, const std::function<void(StereoPair&)>& change)
      : drive_(drive), odometry_(drive.odometry()), view_(drive.view()) {
    change(std::get<StereoPair>(view_.data));
    step_ = drive_.method().observe(odometry_, &view_, {100ms, {0.4, 0.0}, std::nullopt});
  }
  void expect(std::string_view reason) const {
    EXPECT_FALSE(step_.seen);
    EXPECT_EQ(step_.blind_reason, reason);
    EXPECT_FALSE(odometry_.has_seen);
    EXPECT_FALSE(odometry_.scan) << "what is not seen gives no scan";
    EXPECT_NEAR(odometry_.blind_m, 0.04, 0.015);
    EXPECT_EQ(odometry_.window->size(), drive_.odometry().window->size()) << "nor points";
    const auto content = drive_.method().extract(odometry_, view_);
    ASSERT_FALSE(content);
    EXPECT_EQ(content.error().reason, "blind");
  }

 private:
  const test::SimDrive& drive_;
  Topometric::Odometry odometry_;
  View view_;
  Step step_;
};

Image of_grey(const Image& like, std::uint8_t grey) {
  return {like.width, like.height, std::make_shared<const Bytes>(like.pixels->size(), grey)};
}

TEST(TopometricObserve, ACoveredDarkOrFrozenPairGivesNothing) {
  test::SimDrive drive(hall(), kStart);
  drive.drive(0.4);
  Blinded(drive, [](StereoPair& pair) { pair.left = of_grey(pair.left, 60); }).expect("covered");
  Blinded(drive, [](StereoPair& pair) { pair.left = pair.right = of_grey(pair.left, 2); }).expect("too_dark");
  Blinded(drive, [](StereoPair&) {}).expect("frozen");
}

TEST(TopometricObserve, ARightImageOfElsewhereGivesNoScan) {
  test::SimDrive drive(hall(), kStart);
  drive.drive(0.4);
  test::SimDrive elsewhere(hall(), {8.0, 6.0, 2.0});
  elsewhere.step({});
  Topometric::Odometry odometry = drive.odometry();
  View view = drive.view();
  auto& pair = std::get<StereoPair>(view.data);
  pair.right = std::get<StereoPair>(elsewhere.view().data).right;
  pair.left.pixels = std::make_shared<const Bytes>(*std::get<StereoPair>(drive.view().data).left.pixels);
  drive.method().observe(odometry, &view, {100ms, {0.4, 0.0}, std::nullopt});
  EXPECT_FALSE(odometry.scan);
  EXPECT_FALSE(odometry.has_seen);
}

TEST(TopometricObserve, WithoutAViewItDrivesBlindAndKeepsWhatItRemembers) {
  test::SimDrive drive(hall(), kStart);
  drive.drive(0.4);
  Topometric::Odometry odometry = drive.odometry();
  const std::size_t frames = odometry.window->size();
  ASSERT_GT(frames, 1U);
  for (int i = 0; i < 5; ++i) drive.method().observe(odometry, nullptr, {100ms, {0.4, 0.0}, std::nullopt});
  EXPECT_NEAR(odometry.blind_m, 0.2, 0.03);
  EXPECT_EQ(odometry.window->size(), frames) << "0.2 m are bridged";
  EXPECT_TRUE(odometry.costmap);
  for (int i = 0; i < 5; ++i) drive.method().observe(odometry, nullptr, {100ms, {0.4, 0.0}, std::nullopt});
  EXPECT_EQ(odometry.window->size(), 0U) << "0.4 m are not";
}

TEST(TopometricSight, AFloorIsFoundWhereTheMountIsOff) {
  const StereoRig rig{320, 240, 208.0, 159.5, 119.5, 0.12, downward_mount(0.15, 0.06, 0.45, 0.1, 0.0, 0.0)};
  const Pose3 truth = level_above(Eigen::Vector3d(0.02, -0.015, 1.0).normalized(), 0.02);
  std::vector<Eigen::Vector3f> points;
  for (double x = 0.8; x < 4.0; x += 0.05)
    for (double y = -1.5; y < 1.5; y += 0.05)
      points.push_back((truth.inverse() * Eigen::Vector3d(x, y, 0.0)).cast<float>());
  Pose3 level;
  for (int i = 0; i < 4; ++i) {
    const auto found = fit_floor(points, rig, level, {});
    ASSERT_TRUE(found);
    level = found->level_from_robot;
  }
  const Pose3 off = level * truth.inverse();
  EXPECT_NEAR(off.translation.z(), 0.0, 0.002);
  EXPECT_LT(Eigen::AngleAxisd(off.rotation).angle(), 0.002);
  EXPECT_NEAR(project(level).heading, 0.0, 1e-3) << "heading kept";
  EXPECT_FALSE(fit_floor({}, rig, level, {}));
}

TEST(TopometricMake, RefusesWhatIsNoPairThatLooksAhead) {
  EXPECT_FALSE(Topometric::make({}, Rig{}));
  Sensor sensor;
  sensor.id = "one";
  sensor.camera.robot_from_camera = downward_mount(0.1, 0.0, 0.5, 0.1, 0.0, 0.0);
  EXPECT_FALSE(Topometric::make({}, Rig{{sensor}}));
  sensor.kind = SensorKind::stereo;
  sensor.camera.robot_from_camera = downward_mount(0.1, 0.0, 0.5, 1.2, 0.0, 0.0);
  sensor.right = sensor.camera;
  const auto down = Topometric::make({}, Rig{{sensor}});
  ASSERT_FALSE(down);
  EXPECT_THAT(down.error().message, testing::HasSubstr("does not look ahead"));
  TopometricConfig config;
  config.sight.range_m = 0.0;
  EXPECT_THAT(Topometric::make(config, Rig{{sensor}}).error().message, testing::HasSubstr("sight.range_m"));
}

}  // namespace
}  // namespace weft::agents
