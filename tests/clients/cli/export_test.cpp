#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "clients/cli/files.hpp"
#include "storage/formats/g2o.hpp"
#include "storage/formats/route_graph.hpp"
#include "storage/formats/trajectory.hpp"
#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {
namespace {

std::string at(const std::string& name) {
  return (folder() / name).string();
}

std::string text_of(const std::string& file) {
  const auto text = read_text(file);
  EXPECT_TRUE(text.has_value()) << file;
  return text ? *text : std::string{};
}

TEST(Export, EveryFormatHoldsTheWholeNetwork) {
  Fleet fleet;
  const std::size_t places = fleet.service->snapshot().place_count();
  for (const char* const name : {"map.g2o", "map.geojson", "map.dot", "map.graphml"}) {
    const Said said = fleet.weft({"map", "export", at(name)});
    ASSERT_EQ(said.exit, Exit::done) << said.err;
  }
  const auto graph = formats::read_g2o(text_of(at("map.g2o")), "map.g2o");
  ASSERT_TRUE(graph.has_value()) << graph.error().message;
  EXPECT_EQ(graph->value.vertices.size(), places);
  EXPECT_TRUE(graph->not_understood.empty());
  const auto routes = formats::read_route_graph(text_of(at("map.geojson")), "map.geojson");
  ASSERT_TRUE(routes.has_value()) << routes.error().message;
  EXPECT_EQ(routes->value.nodes.size(), places);
  EXPECT_EQ(text_of(at("map.dot")).substr(0, 12), "digraph weft");
  EXPECT_NE(text_of(at("map.graphml")).find("<graphml"), std::string::npos);
}

TEST(Export, AnchorsPutItIntoTheSitesFrame) {
  Fleet fleet;
  const Said said = fleet.weft({"map", "export", at("site.geojson"), "--anchor", "dock=100,50,0", "--json"});
  ASSERT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(said.json()["anchors"], "held by one anchor");
  const auto routes = formats::read_route_graph(text_of(at("site.geojson")), "site.geojson");
  ASSERT_TRUE(routes.has_value());
  const formats::RouteGraph::Node& dock = routes->value.nodes.at(30);
  EXPECT_NE(dock.metadata.find("dock"), std::string::npos);
  EXPECT_NEAR(dock.position.x(), 100.0, 1e-9);
  EXPECT_NEAR(dock.position.y(), 50.0, 1e-9);
}

TEST(Export, ATrajectoryNeedsToBeTold) {
  Fleet fleet;
  const Said both = fleet.weft({"map", "export", at("map.tum")});
  EXPECT_EQ(both.exit, Exit::usage);
  EXPECT_NE(both.err.find("--experience"), std::string::npos);
  // This fleet's places have no times.
  const Said timeless = fleet.weft({"map", "export", at("map.tum"), "--experience", "00000000000000a1"});
  EXPECT_EQ(timeless.exit, Exit::usage);
  EXPECT_NE(timeless.err.find("no times of a trajectory"), std::string::npos) << timeless.err;
}

TEST(Export, WhatDoesNotGoTogetherIsUsage) {
  Fleet fleet;
  EXPECT_EQ(fleet.weft({"map", "export", at("a.json"), "--anchor", "dock=1,2,3"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "export", at("a.g2o"), "--experience", "a1"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "export", at("a.g2o"), "--anchor", "dock"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "draw", at("a.png"), "--anchor", "dock=1,2,3"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "export", at("a.g2o"), "--anchor", "nowhere=1,2,3"}).exit, Exit::refused);
}

std::string floor_plan(const std::string& yaml) {
  std::ofstream(at("plan.pgm"), std::ios::binary) << "P5 4 2 255\n"
                                                  << std::string("\xff\xff\xff\xff\x01\x01\x01\x01", 8);
  std::ofstream(at("plan.yaml")) << yaml;
  return at("plan.yaml");
}
const std::string kPlan =
    "image: plan.pgm\nresolution: 5\norigin: [-2, -3, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n";

TEST(DrawUponAPlan, HasThePlanInIt) {
  Fleet fleet;
  const std::string plan = floor_plan(kPlan + "colour: red\n");
  const Said said = fleet.weft(
      {"map", "draw", at("on.svg"), "--floor-plan", plan, "--anchor", "dock=10,5,0", "--anchor", "packing=3,3"});
  ASSERT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_NE(said.out.find("2 anchors fit within"), std::string::npos);
  EXPECT_NE(said.err.find("plan.yaml:7: colour, once"), std::string::npos) << said.err;
  EXPECT_NE(text_of(at("on.svg")).find("<image"), std::string::npos);
  ASSERT_EQ(fleet.weft({"map", "draw", at("off.svg")}).exit, Exit::done);
  EXPECT_EQ(text_of(at("off.svg")).find("<image"), std::string::npos);
}

TEST(DrawUponAPlan, ItsImageMayBeAPng) {
  const std::vector<std::uint8_t> png = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
      0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0xd1, 0x49, 0x20, 0x56, 0x00, 0x00, 0x00,
      0x0b, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0xf8, 0xcf, 0x08, 0x00, 0x02, 0x02, 0x01, 0x01, 0xab, 0xa8,
      0x27, 0x30, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};  // grey, 2 x 1
  std::ofstream(at("plan.png"), std::ios::binary) << std::string(png.begin(), png.end());
  Fleet fleet;
  const std::string plan = floor_plan("image: plan.png\n" + kPlan.substr(kPlan.find('\n') + 1));
  const Said said = fleet.weft({"map", "draw", at("on.svg"), "--floor-plan", plan, "--anchor", "dock=10,5,0"});
  ASSERT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_NE(text_of(at("on.svg")).find("<image"), std::string::npos);
}

TEST(DrawUponAPlan, WhatIsWrongWithThePlanIsSaid) {
  Fleet fleet;
  const auto draw = [&fleet](const std::string& plan) {
    return fleet.weft({"map", "draw", at("on.png"), "--floor-plan", plan, "--anchor", "dock=10,5,0"});
  };
  EXPECT_EQ(draw("/nowhere/plan.yaml").exit, Exit::usage);
  const Said jpg = draw(floor_plan("image: plan.jpg\n" + kPlan.substr(kPlan.find('\n') + 1)));
  EXPECT_EQ(jpg.exit, Exit::usage);
  EXPECT_NE(jpg.err.find("is neither PGM nor PNG"), std::string::npos);
  EXPECT_NE(draw(floor_plan("image: plan.pgm\n")).err.find("plan.yaml:1: the key resolution is missing"),
            std::string::npos);
  EXPECT_EQ(fleet.weft({"map", "draw", at("on.png"), "--floor-plan", floor_plan(kPlan)}).exit, Exit::refused);
}

}  // namespace
}  // namespace weft::cli::test
