#include "clients/evaluate/floor/replay.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "agents/bodies/sim/changes.hpp"
#include "tests/clients/evaluate/floor/recorded_drive.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

agents::sim::SimBodyConfig small_robot() {
  agents::sim::SimBodyConfig config;
  config.site.name = "small";
  config.site.floor.material = "asphalt";
  config.site.camera.width = 376;
  config.site.camera.height = 240;
  config.site.camera.focal_px = 230.0;
  config.site.camera.cx_px = 187.5;
  config.site.camera.cy_px = 119.5;
  config.site.robots = {{"r1", {2.0, 6.0, 0.0}, 1}};
  config.robot = "r1";
  return config;
}

class ReplayOfFloors : public testing::Test {
 protected:
  ReplayOfFloors() {
    options.recording = folder.path() / "recording";
    options.out = folder.path() / "out";
  }
  Result<Ended> run() {
    return replay_floor(options, {out, progress, [this] { return clock += 0.01; }, [this] { return stops; }});
  }
  std::string refusal() {
    const Result<Ended> ended = run();
    return ended ? "not refused" : ended.error().message;
  }
  nlohmann::json numbers() const {
    std::ifstream in(options.out / "replay.json");
    return nlohmann::json::parse(in)["numbers"];
  }

  storage::TemporaryDirectory folder;
  ReplayOptions options;
  double clock = 0.0;
  bool stops = false;
  std::ostringstream out, progress;
};

TEST_F(ReplayOfFloors, ARecordingIsMappedLocalisedAndCompared) {
  const auto recorded = record_drive(small_robot(), {{2.0, 6.0}, {4.0, 6.0}, {5.0, 6.3}}, options.recording);
  ASSERT_TRUE(recorded.has_value()) << recorded.error().message;
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  const nlohmann::json all = numbers();
  EXPECT_NEAR(all["driven by odometry, m"].get<double>(), 3.0, 0.2);
  EXPECT_GT(all["of them vision took part in, %"], 95.0);
  EXPECT_GT(all["places kept"], 10);
  EXPECT_LT(all["speed error, %"], 4.0);
  EXPECT_LT(all["position after alignment, RMSE, m"], 0.03);
  EXPECT_LT(all["truth out of its plane, RMS, m"], 1e-3);
  EXPECT_GT(all["fixes with a truth"], 10);
  EXPECT_EQ(all["of them wrong (> 0.10 m or > 3 degrees)"], 0);
  EXPECT_GT(std::filesystem::file_size(options.out / "replay.png"), 10'000U);
  EXPECT_NE(out.str().find("| speed error, %"), std::string::npos) << out.str();

  std::filesystem::remove(options.recording / "groundtruth_tum.txt");
  ASSERT_TRUE(run().has_value());
  EXPECT_FALSE(numbers().contains("speed error, %"));
  EXPECT_GT(numbers()["fixes"], 10);
  stops = true;
  EXPECT_EQ(*run(), Ended::stopped);
}

TEST_F(ReplayOfFloors, WhatIsMissingIsNamed) {
  EXPECT_NE(refusal().find("data.csv: missing"), std::string::npos) << refusal();
  options.truth = folder.path() / "none.txt";
  EXPECT_NE(refusal().find("none.txt: no such trajectory"), std::string::npos) << refusal();
  std::ofstream(options.truth) << "1 2 3\n";
  EXPECT_NE(refusal().find("none.txt:1"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace weft::evaluate::floor
