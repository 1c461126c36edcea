// Checks that a pair sees what is near displaced by focal length times baseline over distance.
#include <gmock/gmock.h>

#include <cstdlib>
#include <limits>

#include "agents/bodies/sim/simulated_camera.hpp"
#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;

constexpr double kWallX = 6.5;

/// Returns a hall with a wall across the way, and a robot before it whose pair has no error.
Site site_before_a_wall() {
  Site site = empty_site();
  site.robots.front().looks.clear();
  site.robots.front().has_stereo = true;
  site.disturbances = no_disturbances();
  Box wall;
  wall.kind = Box::Kind::wall;
  wall.site_from_box = {kWallX, 6.0, M_PI / 2};
  wall.length_m = 10.0;
  wall.width_m = 0.2;
  wall.height_m = 4.0;
  site.boxes.push_back(wall);
  StereoCameraSetup& pair = site.stereo_camera;
  pair.pitch_rad = 0.0;
  pair.focal_error = pair.baseline_error = pair.relative_pitch_error_rad = pair.relative_yaw_error_rad = 0.0;
  return site;
}

StereoPair seen_from(const Site& site) {
  auto body = make_sim_body(config_of(site));
  EXPECT_TRUE(body);
  for (int i = 0; i < 20; ++i) {
    const Result<Sample> sample = (*body)->step({});
    if (sample && !sample->views.empty() && i > 10) return std::get<StereoPair>(sample->views.front().data);
  }
  return {};
}

int grey(const Image& image, int column, int row) {
  return (*image.pixels)[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(column)];
}

/// Returns by how many columns what is in the middle of the left image lies further left in the right one.
int displacement(const StereoPair& pair) {
  constexpr int kHalf = 24;
  const int u = pair.left.width / 2;
  const int v = pair.left.height / 2;
  int best = -1;
  long least = std::numeric_limits<long>::max();
  for (int d = 0; d < 60; ++d) {
    long sum = 0;
    for (int y = -kHalf; y <= kHalf; ++y)
      for (int x = -kHalf; x <= kHalf; ++x)
        sum += std::abs(grey(pair.left, u + x, v + y) - grey(pair.right, u + x - d, v + y));
    if (sum < least) {
      least = sum;
      best = d;
    }
  }
  return best;
}

TEST(SimulatedStereoCamera, SeesAWallDisplacedByItsDistance) {
  Site site = site_before_a_wall();
  for (const double baseline_m : {0.1, 0.2}) {
    site.stereo_camera.baseline_m = baseline_m;
    const double away_m = kWallX - 0.1 - (4.0 + site.stereo_camera.forward_m);
    const StereoPair pair = seen_from(site);
    ASSERT_EQ(pair.left.width, site.stereo_camera.width);
    ASSERT_EQ(pair.right.width, site.stereo_camera.width);
    EXPECT_NEAR(displacement(pair), site.stereo_camera.focal_px * baseline_m / away_m, 0.75);
  }
}

TEST(SimulatedStereoCamera, ATurnOfTheRightCameraShiftsAllThatItSees) {
  Site site = site_before_a_wall();
  const int right = displacement(seen_from(site));
  site.stereo_camera.relative_yaw_error_rad = 0.05;  // 10 px of RMS: some draw of these is more than 2
  int most = 0;
  for (std::uint64_t day = 0; day < 3; ++day) {
    site.robots.front().seed = 100 + day;
    most = std::max(most, std::abs(displacement(seen_from(site)) - right));
  }
  EXPECT_GE(most, 2);
}

TEST(SimulatedStereoCamera, IsOneSensorOfTwoCalibratedCameras) {
  const auto body = make_sim_body(config_of(site_before_a_wall(), "r1", 1, 3));
  ASSERT_TRUE(body);
  const Rig rig = (*body)->rig();
  ASSERT_EQ(rig.sensors.size(), 1U);
  const Sensor& pair = rig.sensors.front();
  EXPECT_EQ(pair.kind, SensorKind::stereo);
  EXPECT_EQ(pair.gaze(), Gaze::ahead);
  EXPECT_EQ(pair.camera.id, "r1/stereo/day3/left");
  ASSERT_TRUE(pair.right);
  EXPECT_EQ(pair.right->id, "r1/stereo/day3/right");
  const Eigen::Vector3d apart = pair.camera.robot_from_camera.translation - pair.right->robot_from_camera.translation;
  EXPECT_NEAR((apart - Eigen::Vector3d(0.0, StereoCameraSetup().baseline_m, 0.0)).norm(), 0.0, 1e-9)
      << "x ahead, y to the left";
}

TEST(SimulatedStereoCamera, TheSameDayGivesTheSamePairs) {
  Site site = site_before_a_wall();
  site.disturbances.noise_grey = 2.0;
  const StereoPair once = seen_from(site);
  const StereoPair again = seen_from(site);
  EXPECT_EQ(*once.left.pixels, *again.left.pixels);
  EXPECT_EQ(*once.right.pixels, *again.right.pixels);
}

TEST(SimulatedStereoCamera, KeysOutOfTheirBoundsAreNamed) {
  const std::string site =
      "[floor]\nx_min = 0\ny_min = 0\nx_max = 9\ny_max = 9\n[[robot]]\nname = \"r1\"\nx = 4\ny = 4\n";
  const auto wide = parse_site(site + "[stereo_camera]\nbaseline_m = 5\n", "s.toml");
  ASSERT_FALSE(wide);
  EXPECT_THAT(wide.error().message, HasSubstr("stereo_camera.baseline_m"));
  const auto twice = parse_site(site + "looks = [\"stereo\", \"stereo\"]\n", "s.toml");
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().message, HasSubstr("looks"));
  const auto both = parse_site(site + "looks = [\"down\", \"stereo\"]\n", "s.toml");
  ASSERT_TRUE(both) << both.error().message;
  EXPECT_TRUE(both->robots.front().has_stereo);
  EXPECT_EQ(both->robots.front().looks, std::vector<Gaze>{Gaze::down});
}

}  // namespace
}  // namespace weft::agents::sim
