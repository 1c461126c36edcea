// The scenes of deploy/sites/ceiling.
#include "tests/agents/bodies/sim/scenes.hpp"

namespace weft::agents::sim {
namespace {

const std::string kFolder = std::string(WEFT_SITES) + "/ceiling/";

Site scene(const std::string& name) {
  return scene_in(kFolder, name);
}

TEST(CeilingScenes, HaveLinesThatCanBeDriven) {
  expect_drivable(scene("office.toml"), line_in(kFolder, "office.line"), 20.0);
  expect_drivable(scene("sheet.toml"), line_in(kFolder, "sheet.line"), 20.0);
  expect_drivable(scene("lamps.toml"), line_in(kFolder, "lamps.line"), 20.0);
  expect_drivable(scene("hall.toml"), line_in(kFolder, "straight.line"), 20.0);
  expect_drivable(scene("hall.toml"), line_in(kFolder, "loop.line"), 60.0);
}

TEST(CeilingScenes, TheLampGridIsAsTheRealOne) {
  const Site site = scene("lamps.toml");
  ASSERT_GT(site.lamps.size(), 50U);
  EXPECT_NEAR(site.lamps[1].x - site.lamps[0].x, 3.05, 1e-9);
  EXPECT_NEAR(site.lamps.back().y - site.lamps.front().y, 6 * 3.66, 1e-9);
  EXPECT_EQ(site.hall.ceiling.kind, CeilingKind::bare);
  EXPECT_EQ(site.hall.ceiling.beams_every_m, 0.0);
  EXPECT_TRUE(site.ducts.empty() && site.pipes.empty() && site.skylights.empty());
}

TEST(CeilingScenes, HaveRobotsThatLookUpThroughDifferentCameras) {
  for (const char* name : {"office.toml", "hall.toml", "sheet.toml"}) {
    const Site site = scene(name);
    EXPECT_EQ(site.robots[0].looks, std::vector<Gaze>{Gaze::up}) << name;
    EXPECT_TRUE(site.robots[1].ceiling_camera) << name;
  }
  EXPECT_EQ(scene("hall.toml").robots[1].ceiling_camera->lens, LensModel::equidistant);
}

}  // namespace
}  // namespace weft::agents::sim
