// An aisle that was taught there and back, by the floor: its lanes are stitched head-on, where they cross across.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "tests/agents/agent/process/simulated_robot.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::agents::test {
namespace {

constexpr double kFrom = 2.0, kTo = 7.0;  ///< metres along the aisle

/// Returns a line along y = 3, then across the aisle, and back a hand's breadth beside.
std::vector<SitePoint> there_and_back() {
  return {{kFrom, 3.0},     {kTo, 3.0}, {kTo + 0.6, 3.6}, {kTo, 4.3},  {kTo - 0.6, 3.7},
          {kTo - 0.6, 2.4}, {kTo, 1.8}, {kTo + 0.6, 2.4}, {kTo, 3.05}, {kFrom, 3.05}};
}

class Aisle : public testing::Test {
 protected:
  void SetUp() override {
    const std::string site = (folder.path() / "aisle.toml").string();
    std::ofstream(site) << "[floor]\nx_min = 0.0\ny_min = 0.0\nx_max = 10.0\ny_max = 6.0\n"
                           "[camera]\nwidth_px = 376\nheight_px = 240\nfocal_px = 230\n"
                           "[[robot]]\nname = \"r1\"\nx = 2.0\ny = 3.0\n";
    SimulatedRobot robot(site, "r1", {"floor"}, map);
    robot.be_taught(10, there_and_back(), truth);
  }

  storage::TemporaryDirectory folder;
  weft::test::LittleServer map;
  std::map<PlaceId, Pose2> truth;
};

double turn_of(const Edge& edge) {
  return std::abs(planar(edge.a_from_b).heading);
}

TEST_F(Aisle, IsStitchedHeadOnOnceAMetreAndWhereItIsCrossed) {
  std::vector<double> at;  // the middle of what a place there and one back both saw, metres
  int crossings = 0;
  for (const auto& [id, edge] : map.window().edges) {
    if (edge.origin != Origin::stitch || edge.drivable != Drivable::none) continue;
    const Pose2 truly = truth.at(id.a).inverse() * truth.at(id.b);
    const Pose2 wrong_by = truly.inverse() * planar(edge.a_from_b);
    EXPECT_LT(wrong_by.translation().norm(), 0.02);
    EXPECT_LT(std::abs(wrong_by.heading), 0.02);
    const bool is_head_on = turn_of(edge) > 0.75 * std::numbers::pi;
    if (!is_head_on) ++crossings;
    if (is_head_on) at.push_back((truth.at(id.a).x + truth.at(id.b).x) / 2.0);
  }
  std::sort(at.begin(), at.end());
  ASSERT_FALSE(at.empty());
  EXPECT_LT(at.front(), kFrom + 1.0);
  EXPECT_GT(at.back(), kTo - 1.0);
  for (std::size_t i = 1; i < at.size(); ++i) EXPECT_LT(at[i] - at[i - 1], 1.0) << "from " << at[i - 1] << " m on";
  EXPECT_GE(crossings, 1);
}

}  // namespace
}  // namespace weft::agents::test
