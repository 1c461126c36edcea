// Checks how a site file describes a ceiling and the camera that looks up at it.
#include "agents/bodies/sim/ceiling_keys.hpp"

#include <gmock/gmock.h>

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;

constexpr const char* kBareSite = R"(
name = "small"
[floor]
x_min = 0
y_min = 0
x_max = 5
y_max = 4
[[robot]]
name = "r1"
x = 1
y = 2
)";

TEST(CeilingKeys, WhatHangsUnderACeiling) {
  const auto site = parse_site(std::string(kBareSite) + R"(
looks = ["down", "up"]
[hall]
ceiling_m = 6.4
ceiling = "sheet"
beams_every_m = 0
sprinklers_every_m = 3
lamp_length_m = 0.6
[[duct]]
from = [0, 1]
to = [4, 1]
below_m = 0.9
[[pipe]]
from = [0, 2]
to = [4, 2]
diameter_m = 0.2
[[skylight]]
x = 2
y = 2
brightness = 0.5
[[lamp_grid]]
x = 0.5
y = 1
apart_x_m = 3.05
apart_y_m = 3.66
columns = 2
rows = 3
[[forklift]]
way = [0.5, 3.0, 4.0, 3.0]
forks_m = 2.5
[change]
skylight_percent = 400
[[change.duct]]
from = [0, 3]
to = [4, 3]
)",
                               "small.toml");
  ASSERT_TRUE(site) << site.error().message;
  EXPECT_EQ(site->robots.front().looks, (std::vector<Gaze>{Gaze::down, Gaze::up}));
  EXPECT_EQ(site->hall.ceiling.kind, CeilingKind::sheet);
  EXPECT_EQ(site->hall.ceiling.beams_every_m, 0.0);
  EXPECT_EQ(site->hall.ceiling.sprinklers_every_m, 3.0);
  EXPECT_EQ(site->hall.ceiling.lamp_length_m, 0.6);
  ASSERT_EQ(site->ducts.size(), 1U);
  EXPECT_EQ(site->ducts.front().below_m, 0.9);
  ASSERT_EQ(site->pipes.size(), 1U);
  EXPECT_EQ(site->pipes.front().diameter_m, 0.2);
  ASSERT_EQ(site->skylights.size(), 1U);
  ASSERT_EQ(site->lamps.size(), 6U);
  EXPECT_EQ(site->lamps.back().x, 0.5 + 3.05);
  EXPECT_EQ(site->lamps.back().y, 1.0 + 2 * 3.66);
  EXPECT_EQ(site->movers.front().forks_m, 2.5);
  EXPECT_EQ(site->change.skylight, 4.0);
  EXPECT_EQ(site->change.ducts.size(), 1U);
}

TEST(CeilingKeys, TheCameraThatLooksUp) {
  const auto site = parse_site(std::string(kBareSite) + R"(
looks = ["up"]
[robot.ceiling_camera]
tilt_left_deg = -3
mast = { forward_m = -0.2, side_m = 0.05 }
[ceiling_camera]
lens = "equidistant"
focal_px = 250
k4 = 0.001
height_m = 0.5
tilt_forward_deg = 10
tilt_error_forward_deg = 1
bloom_percent = 5
mean_grey = 90
)",
                               "small.toml");
  ASSERT_TRUE(site) << site.error().message;
  const CeilingCameraSetup& all = site->ceiling_camera;
  EXPECT_EQ(all.lens, LensModel::equidistant);
  EXPECT_EQ(all.k4, 0.001);
  EXPECT_NEAR(all.tilt_error_forward_rad, M_PI / 180.0, 1e-12);
  EXPECT_NEAR(all.bloom, 0.05, 1e-12);
  EXPECT_EQ(all.mean_grey, 90.0);
  EXPECT_FALSE(all.mast);
  ASSERT_TRUE(site->robots.front().ceiling_camera);
  const CeilingCameraSetup& own = *site->robots.front().ceiling_camera;
  EXPECT_EQ(own.lens, LensModel::equidistant) << "but for what differs the site's";
  EXPECT_EQ(own.height_m, 0.5);
  EXPECT_NEAR(own.tilt_left_rad, -3.0 * M_PI / 180.0, 1e-12);
  ASSERT_TRUE(own.mast);
  EXPECT_EQ(own.mast->side_m, 0.05);
}

std::string refused(const std::string& more) {
  const auto site = parse_site(std::string(kBareSite) + more, "small.toml");
  return site ? std::string("nothing is wrong") : site.error().message;
}

TEST(CeilingKeys, WhatIsWrongIsNamed) {
  EXPECT_THAT(refused("[hall]\nceiling = \"straw\"\n"), HasSubstr("hall.ceiling"));
  EXPECT_THAT(refused("[hall]\nbeams_every_m = 0.2\n"), HasSubstr("at least 0.5"));
  EXPECT_THAT(refused("[[duct]]\nfrom = [0, 0]\nto = [0, 0]\n"), HasSubstr("0.1 m from `from`"));
  EXPECT_THAT(refused("[hall]\nceiling_m = 3\n[[duct]]\nfrom = [0, 0]\nto = [1, 0]\nbelow_m = 1.2\n"),
              HasSubstr("1.5 m of height"));
  EXPECT_THAT(refused("[[pipe]]\nfrom = [0, 0]\nto = [1, 0]\ndiameter_m = 2\n"), HasSubstr("diameter_m"));
  EXPECT_THAT(refused("[[skylight]]\nx = 1\n"), HasSubstr(".y"));
  EXPECT_THAT(refused("[[lamp_grid]]\nx = 1\ny = 1\napart_x_m = 3\napart_y_m = 3\ncolumns = 0\nrows = 2\n"),
              HasSubstr("columns"));
  EXPECT_THAT(refused("[[forklift]]\nway = [1, 1, 2, 2]\nforks_m = 40\n"), HasSubstr("forks_m"));
  EXPECT_THAT(refused("[[person]]\nway = [1, 1, 2, 2]\nforks_m = 1\n"), HasSubstr("forks_m"));
  EXPECT_THAT(refused("[change]\nskylight_percent = -1\n"), HasSubstr("skylight_percent"));
  EXPECT_THAT(refused("[[change.duct]]\nfrom = [0, 0]\n"), HasSubstr("to"));
}

TEST(CeilingKeys, ACameraThatCannotBeIsNamed) {
  EXPECT_THAT(refused("looks = [\"up\", \"up\"]\n"), HasSubstr("two cameras look up"));
  EXPECT_THAT(refused("[ceiling_camera]\nwidth_px = 642\n"), HasSubstr("multiple of 4"));
  EXPECT_THAT(refused("[ceiling_camera]\nlens = \"rational\"\n"), HasSubstr("ceiling_camera.lens"));
  EXPECT_THAT(refused("[ceiling_camera]\nlens = \"equidistant\"\np1 = 0.001\n"), HasSubstr("p1"));
  EXPECT_THAT(refused("[ceiling_camera]\nk4 = 0.01\n"), HasSubstr("k4"));
  EXPECT_THAT(refused("[ceiling_camera]\nk1 = -0.4\n"), HasSubstr("no sound lens"));
  EXPECT_THAT(refused("[ceiling_camera]\ntilt_forward_deg = 40\ntilt_left_deg = 30\n"),
              HasSubstr("does not look up"));
  EXPECT_THAT(refused("[ceiling_camera]\nbloom_percent = 60\n"), HasSubstr("bloom_percent"));
  EXPECT_THAT(refused("[ceiling_camera.mast]\nforward_m = 0\n"), HasSubstr("it would be in it"));
}

}  // namespace
}  // namespace weft::agents::sim
