#include "clients/cli/mosaic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include "agents/methods/ceiling/content.hpp"
#include "tests/clients/cli/handed_in_run.hpp"

/// Lays patches of ceiling places together, and draws them of a small map as operators ask.
namespace weft::cli::test {
namespace {

constexpr double kPixelM = 0.05;
constexpr int kPatchPx = 21;

/// Returns what a place at that pose sees of a ceiling that is bright north of y = 0 and dark south of it.
agents::PlanePatch half_bright(const Pose2& map_from_place) {
  agents::PlanePatch patch;
  patch.width = patch.height = kPatchPx;
  patch.metres_per_pixel = kPixelM;
  constexpr double middle_px = 0.5 * (kPatchPx - 1);
  patch.first_pixel_on_plane = kPixelM * Eigen::Vector2d::Constant(middle_px);
  for (int row = 0; row < kPatchPx; ++row) {
    for (int column = 0; column < kPatchPx; ++column) {
      const Eigen::Vector2d in_place = patch.first_pixel_on_plane - kPixelM * Eigen::Vector2d(row, column);
      patch.pixels.push_back((map_from_place * in_place).y() > 0.0 ? 200 : 50);
    }
  }
  return patch;
}

std::uint8_t grey_at(const Mosaic& mosaic, double x, double y) {
  const auto cell = [&](double metres) { return static_cast<std::size_t>(metres / mosaic.metres_per_pixel); };
  const std::size_t row = cell(mosaic.corner_in_drawing.y() - y);
  return mosaic.greys.at(row * mosaic.columns + cell(x - mosaic.corner_in_drawing.x()));
}

TEST(LayMosaic, PatchesLieAsTheirPlacesAreTurned) {
  std::vector<LaidPatch> patches;
  for (const Pose2& pose : {Pose2{0.0, 0.1, 0.0}, Pose2{0.5, -0.1, std::numbers::pi / 2}, Pose2{1.0, 0.0, -2.3}})
    patches.push_back({pose, half_bright(pose)});
  const Mosaic mosaic = lay_mosaic(patches);
  EXPECT_DOUBLE_EQ(mosaic.metres_per_pixel, kPixelM);
  for (const double x : {-0.3, 0.0, 0.3, 0.5, 0.8, 1.0, 1.3}) {
    EXPECT_NEAR(grey_at(mosaic, x, 0.2), 200, 1) << x;
    EXPECT_NEAR(grey_at(mosaic, x, -0.2), 50, 1) << x;
  }
  EXPECT_EQ(grey_at(mosaic, -0.45, -0.55), 0) << "seen by none";
  EXPECT_TRUE(mosaic.covers({0.5, 0.0}));
  EXPECT_FALSE(mosaic.covers({5.0, 0.0}));
}

TEST(LayMosaic, WhatACameraDoesNotSeeIsLeftToTheOthers) {
  LaidPatch blind{{}, half_bright({})};
  std::fill(blind.patch.pixels.begin(), blind.patch.pixels.end(), std::uint8_t{0});
  const Pose2 beside{0.1, 0.0, 0.0};
  const Mosaic mosaic = lay_mosaic({blind, {beside, half_bright(beside)}, {{}, {}}});
  EXPECT_EQ(grey_at(mosaic, 0.0, 0.2), 200);
  EXPECT_EQ(grey_at(mosaic, -0.47, 0.2), 0);
}

TEST(LayMosaic, AHugeMapIsLaidMoreCoarsely) {
  const Pose2 far{1000.0, 400.0, 0.0};
  const Mosaic mosaic = lay_mosaic({{{}, half_bright({})}, {far, half_bright(far)}});
  EXPECT_LT(mosaic.rows * mosaic.columns, 17'000'000U);
  EXPECT_GT(mosaic.metres_per_pixel, 0.1);
}

/// Returns the bytes of a place of method `ceiling` there.
Bytes ceiling_place(const Pose2& map_from_place) {
  agents::CeilingContent content;
  content.camera.id = "r1/ceiling";
  content.camera.width = 640;
  content.camera.height = 480;
  content.camera.fx = content.camera.fy = 300.0;
  content.camera.cx = 320.0;
  content.camera.cy = 240.0;
  content.camera.robot_from_camera.translation.z() = 0.5;
  content.attitude_sigma.setConstant(0.001);
  content.ceiling_m = 6.4;
  content.ceiling_sigma_m = 0.05;
  content.patch = half_bright(map_from_place);
  return agents::encode_ceiling_content(content);
}

/// Adds a run of method `ceiling` to the map: eight places along y = 0, the last one labelled.
void teach_below_ceiling(Fleet& fleet, const ExperienceId& experience) {
  constexpr double apart_m = 0.4;
  std::vector<Bytes> contents;
  for (std::uint32_t i = 0; i < 8; ++i) contents.push_back(ceiling_place({apart_m * i, 0.0, 0.0}));
  hand_in(fleet, {.experience = experience,
                  .method = "ceiling",
                  .contents = contents,
                  .apart_m = apart_m,
                  .drivable = Drivable::a_to_b,
                  .label = "press",
                  .labelled = 7});
}

TEST(MapMosaic, IsRefusedWhereNoPlaceHasAPatch) {
  Fleet fleet;
  const Said said = fleet.weft({"map", "draw", "--mosaic", (folder() / "mosaic.png").string()});
  EXPECT_EQ(said.exit, Exit::refused);
  EXPECT_NE(said.err.find("only those that robots of method ceiling were taught have"), std::string::npos)
      << said.err;
}

TEST(MapMosaic, IsDrawnOfTheContentsThatTheServerHas) {
  Fleet fleet;
  teach_below_ceiling(fleet, {0xC3});
  const std::string file = (folder() / "mosaic.svg").string();
  const Said said = fleet.weft({"map", "draw", "--mosaic", file});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_NE(said.out.find("8 of"), std::string::npos) << said.out;
  std::ifstream in(file, std::ios::binary);
  const std::string svg{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(svg.find("<image"), std::string::npos);
  const auto document = fleet.weft({"map", "draw", "--mosaic", (folder() / "mosaic.png").string(), "--json"}).json();
  EXPECT_EQ(document["mosaic"]["patches"], 8);
  EXPECT_NEAR(document["mosaic"]["metres_per_pixel"].get<double>(), kPixelM, 1e-9);
}

TEST(MapMosaic, LiesInTheFrameOfTheRegisteredPlan) {
  Fleet fleet;
  teach_below_ceiling(fleet, {0xC3});
  const std::filesystem::path plan = folder() / "hall.yaml";
  std::ofstream(folder() / "hall.pgm") << "P2\n2 1\n255\n254 254\n";
  std::ofstream(plan) << "image: hall.pgm\nresolution: 5.0\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
                         "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
  const Said registered = fleet.weft({"map", "register", plan.string(), "--pick", "press=8,3,0.5"});
  ASSERT_EQ(registered.exit, Exit::done) << registered.err;
  const std::vector<std::string> draw = {"map", "draw", "--mosaic", (folder() / "mosaic.png").string()};
  EXPECT_NE(fleet.weft(draw).out.find("in the frame of plan hall"), std::string::npos);
  std::vector<std::string> free = draw;
  free.emplace_back("--no-plan");
  EXPECT_EQ(fleet.weft(free).out.find("in the frame of plan"), std::string::npos);
  std::vector<std::string> other = draw;
  other.insert(other.end(), {"--plan", "cellar"});
  const Said said = fleet.weft(other);
  EXPECT_NE(said.exit, Exit::done);
  EXPECT_NE(said.err.find("plan cellar is not registered"), std::string::npos) << said.err;
}

}  // namespace
}  // namespace weft::cli::test
