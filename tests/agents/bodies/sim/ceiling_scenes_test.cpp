// The scenes of deploy/sites/ceiling.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "agents/bodies/sim/base.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {
namespace {

const std::string kFolder = std::string(WEFT_SITES) + "/ceiling/";

Site scene(const std::string& name) {
  const std::ifstream file(kFolder + name);
  std::stringstream text;
  text << file.rdbuf();
  const Result<Site> site = parse_site(text.str(), name);
  EXPECT_TRUE(site) << site.error().message;
  return site ? *site : Site{};
}

std::vector<Eigen::Vector2d> line_in(const std::string& name) {
  std::vector<Eigen::Vector2d> line;
  std::ifstream rows(kFolder + name);
  for (std::string row; std::getline(rows, row);) {
    std::istringstream numbers(row.substr(0, row.find('#')));
    Eigen::Vector2d p;
    if (numbers >> p.x() >> p.y()) line.push_back(p);
  }
  return line;
}

/// Expects a line as long as that, on which a robot keeps half a metre from everything; r1 stands at its beginning.
void expect_drivable(const Site& site, const std::string& name, double length_m) {
  const std::vector<Eigen::Vector2d> line = line_in(name);
  ASSERT_GE(line.size(), 2U) << name;
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d way = line[i] - line[i - 1];
    for (double s = 0.0; s < way.norm(); s += 0.1) {
      const Eigen::Vector2d p = line[i - 1] + way.normalized() * s;
      EXPECT_TRUE(p.x() > 1.0 && p.x() < site.floor.x_max - 1.0 && p.y() > 1.0 && p.y() < site.floor.y_max - 1.0);
      for (const Box& box : site.boxes)
        EXPECT_GT(distance_to(box, p.x(), p.y()), site.base.radius_m + 0.5) << name << " and " << box.name;
    }
    length += way.norm();
  }
  EXPECT_NEAR(length, length_m, 0.5) << name;
}

TEST(CeilingScenes, HaveLinesThatCanBeDriven) {
  expect_drivable(scene("office.toml"), "office.line", 20.0);
  expect_drivable(scene("sheet.toml"), "sheet.line", 20.0);
  expect_drivable(scene("lamps.toml"), "lamps.line", 20.0);
  expect_drivable(scene("hall.toml"), "straight.line", 20.0);
  expect_drivable(scene("hall.toml"), "loop.line", 60.0);
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
