#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/clients/cli/one_robot.hpp"

namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;

TEST(MapCommands, MapInfoCounts) {
  Fleet fleet;
  const auto info = fleet.weft({"map", "info", "--json"}).json();
  EXPECT_EQ(info["experiences"], 2);
  EXPECT_EQ(info["places"], fleet.service->snapshot().place_count());
  EXPECT_EQ(info["stitches"], fleet.service->snapshot().stitch_count());
  EXPECT_GT(info["stitches"], 5);
  EXPECT_NE(fleet.weft({"map", "info"}).out.find("places"), std::string::npos);
}

TEST(MapCommands, LabelsAPlace) {
  Fleet fleet;
  EXPECT_EQ(fleet.weft({"map", "label", "00000000000000b2:9", "gate"}).exit, Exit::done);
  EXPECT_EQ(fleet.service->snapshot().labels().at("gate"), (PlaceId{fleet.second, 9}));
  EXPECT_EQ(fleet.weft({"map", "label", "00000000000000b2:900", "gate"}).exit, Exit::refused);
  EXPECT_EQ(fleet.weft({"map", "label", "b2", "gate"}).exit, Exit::usage);
}

TEST(MapCommands, LabelsWhereARobotStands) {
  OneRobot fleet;
  const Said said = fleet.weft({"map", "label", "here", "--robot", "r1", "gate"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(fleet.service->snapshot().labels().at("gate"), (PlaceId{fleet.first, 4}));
}

TEST(MapCommands, ExportsWhatTheJudgeReads) {
  OneRobot fleet;
  const std::string file = (folder() / "network.json").string();
  ASSERT_EQ(fleet.weft({"map", "export", file}).exit, Exit::done);
  EXPECT_EQ(fleet.weft({"map", "export", "/nowhere/network.json"}).exit, Exit::failed);
  std::ifstream in(file);
  const nlohmann::json network = nlohmann::json::parse(in);
  EXPECT_EQ(network["places"].size(), fleet.service->snapshot().place_count());
  EXPECT_EQ(network["experiences"].size(), 2U);
  EXPECT_EQ(network["labels"]["dock"], "00000000000000a1:30");
  const auto& place = network["places"][5];
  EXPECT_EQ(place["id"], "00000000000000a1:5");
  EXPECT_EQ(place["robot"], "r1");
  EXPECT_EQ(place["frame"], 50);
  std::size_t stitches = 0;
  for (const auto& edge : network["edges"]) {
    if (edge["origin"] != "stitch") continue;
    ++stitches;
    EXPECT_EQ(edge["inliers"], 55);
    EXPECT_NEAR(edge["a_from_b"]["y"].get<double>(), 0.1, 1e-9);
  }
  EXPECT_EQ(stitches, fleet.service->snapshot().stitch_count());
}

TEST(MapCommands, DrawsAPicture) {
  OneRobot fleet;
  const std::string file = (folder() / "map.png").string();
  EXPECT_EQ(fleet.weft({"map", "draw", file}).exit, Exit::done);
  EXPECT_GT(std::filesystem::file_size(file), 5000U);
  EXPECT_EQ(fleet.weft({"map", "draw", "map.bmp"}).exit, Exit::usage);
}

TEST(MapCommands, MapDrawTellsRunsWithTheirColours) {
  OneRobot fleet;
  const auto document = fleet.weft({"map", "draw", (folder() / "map.png").string(), "--json"}).json();
  ASSERT_EQ(document["runs"].size(), 2U);
  EXPECT_EQ(document["runs"][0]["experience"], "00000000000000a1");
  EXPECT_EQ(document["runs"][0]["colour"], "#d65e00");
  EXPECT_TRUE(document["runs"][0]["name"].is_null());  // nobody has named it
  EXPECT_FALSE(document.contains("robots"));
}

TEST(MapCommands, MapDrawWithRobotsTellsWhoIsNotDrawn) {
  OneRobot fleet;
  fleet.add_robot("r2");
  fleet.run(1s);
  const std::string file = (folder() / "map.svg").string();
  const auto robots = fleet.weft({"map", "draw", file, "--robots", "--json"}).json()["robots"];
  EXPECT_EQ(robots["drawn"], nlohmann::json::array({"r1"}));
  ASSERT_EQ(robots["not_drawn"].size(), 1U);
  EXPECT_EQ(robots["not_drawn"][0]["name"], "r2");
  const Said said = fleet.weft({"map", "draw", file, "--robots"});
  EXPECT_EQ(said.exit, Exit::done);
  EXPECT_NE(said.out.find("not drawn: r2, it does not know where it is"), std::string::npos) << said.out;
}

TEST(MapCommands, MapDrawWithRobotsDrawsTheRouteThatOneHolds) {
  OneRobot fleet;
  Puppet& r2 = fleet.add_robot("r2");
  r2.state.place = {fleet.second, 40};
  r2.state.mode = msg::RobotMode::lost;
  Puppet& r3 = fleet.add_robot("r3");
  r3.state.localised = true;
  r3.state.place = {fleet.second, 25};
  fleet.run(1s);
  const std::string before = (folder() / "before.png").string();
  const std::string after = (folder() / "after.png").string();
  ASSERT_EQ(fleet.weft({"map", "draw", before, "--robots"}).exit, Exit::done);
  ASSERT_EQ(fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--robot", "r1"}).exit, Exit::done);
  fleet.run(3s);
  r3.speak_at = SteadyTime::max();
  fleet.run(10s);
  const auto robots = fleet.weft({"map", "draw", after, "--robots", "--json"}).json()["robots"];
  EXPECT_EQ(robots["drawn"], nlohmann::json::array({"r1", "r2", "r3"}));
  EXPECT_NE(std::filesystem::file_size(before), std::filesystem::file_size(after));
}

TEST(MapCommands, RobotsAreNotDrawnOnAnOldMap) {
  Fleet fleet;
  const Said said = fleet.weft({"map", "draw", (folder() / "map.svg").string(), "--robots", "--at", "1"});
  EXPECT_EQ(said.exit, Exit::usage);
  EXPECT_NE(said.err.find("--robots"), std::string::npos) << said.err;
}

}  // namespace
}  // namespace weft::cli::test
