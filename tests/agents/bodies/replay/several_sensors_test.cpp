// Recordings with more than one camera: each at its own rate, or two as a pair.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "agents/bodies/replay/replay_body.hpp"
#include "tests/support/raw_png.hpp"

namespace weft::agents::replay {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

std::string sensor_yaml(double left_m) {
  return "camera_model: pinhole\nresolution: [32, 24]\nintrinsics: [20.5, 21, 15.5, 11.5]\ndistortion_model: none\n"
         "T_BS:\n  cols: 4\n  rows: 4\n  data: [0, 0, 1, 0.1, -1, 0, 0, " +
         std::to_string(left_m) + ", 0, -1, 0, 0.3, 0, 0, 0, 1]\n";
}

class SeveralSensors : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              (std::string("weft-sensors-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Records a camera whose images are of these milliseconds.
  void record(const std::string& name, double left_m, const std::vector<double>& times_ms) const {
    const fs::path camera = folder_ / "mav0" / name;
    fs::create_directories(camera / "data");
    std::ofstream(camera / "sensor.yaml") << sensor_yaml(left_m);
    std::ofstream list(camera / "data.csv");
    for (const double ms : times_ms) {
      const auto nanoseconds = static_cast<std::int64_t>(1e6 * ms);
      const std::string file = std::to_string(nanoseconds) + ".png";
      list << nanoseconds << "," << file << "\n";
      weft::test::write_png(camera / "data" / file, weft::test::plain_picture(32, 24, static_cast<std::uint8_t>(ms)));
    }
  }
  Result<std::unique_ptr<Body>> open(const std::string& sensors) {
    ReplayBodyConfig config;
    config.folder = folder_.string();
    config.camera = sensors;
    config.warn = [this](const std::string& text) { warnings_ += text + "\n"; };
    return make_replay_body(config);
  }
  /// Plays the recording; returns "time: sensors" of each sample, and how it ended.
  static std::vector<std::string> played(Body& body) {
    std::vector<std::string> all;
    for (;;) {
      const Result<Sample> sample = body.step({});
      if (!sample) break;
      std::string text = std::to_string(sample->time.time_since_epoch().count() / 1'000'000) + ":";
      for (const View& view : sample->views) text += " " + view.sensor;
      all.push_back(text);
    }
    return all;
  }

  fs::path folder_;
  std::string warnings_;
};

TEST_F(SeveralSensors, EachSeesAtItsOwnRate) {
  record("cam0", 0.2, {50, 100, 150});
  record("cam2", 0.0, {60, 100.4, 160});
  auto body = open("cam0,cam2");
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_EQ((*body)->rig().sensors.size(), 2U);
  EXPECT_EQ(played(**body),
            (std::vector<std::string>{"50: cam0", "60: cam2", "100: cam0 cam2", "150: cam0", "160: cam2"}));
}

TEST_F(SeveralSensors, APairIsOneViewOfBothHalves) {
  record("cam0", 0.25, {50, 100, 150});
  record("cam1", 0.05, {50.3, 99.2, 150});
  auto body = open("cam0+cam1");
  ASSERT_TRUE(body) << body.error().message;
  const Rig rig = (*body)->rig();
  ASSERT_EQ(rig.sensors.size(), 1U);
  EXPECT_EQ(rig.sensors[0].kind, SensorKind::stereo);
  EXPECT_EQ(rig.sensors[0].gaze(), Gaze::ahead);
  const Pose3 left_from_right = rig.camera().robot_from_camera.inverse() * rig.sensors[0].right->robot_from_camera;
  EXPECT_NEAR(left_from_right.translation.x(), 0.2, 1e-9) << "in the camera's frame the right one is to the right";
  const auto sample = (*body)->step({});
  ASSERT_EQ(sample->views.size(), 1U);
  const auto& pair = std::get<StereoPair>(sample->views.front().data);
  EXPECT_EQ(pair.left.pixels->at(0), 50);
  EXPECT_EQ(pair.right.pixels->at(0), 50);
  EXPECT_EQ(played(**body), (std::vector<std::string>{"100: cam0+cam1", "150: cam0+cam1"}));
  EXPECT_EQ(warnings_, "");
}

TEST_F(SeveralSensors, HalfAPairDropsTheViewAndIsNamed) {
  record("cam0", 0.25, {50, 100, 150, 200});
  record("cam1", 0.05, {50, 150, 200});
  fs::remove(folder_ / "mav0" / "cam1" / "data" / "150000000.png");
  std::ofstream(folder_ / "mav0" / "cam0" / "data" / "200000000.png") << "not a picture";
  auto body = open("cam0+cam1");
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_EQ(played(**body), (std::vector<std::string>{"50: cam0+cam1", "100:", "150:", "200:"}));
  EXPECT_THAT(warnings_, HasSubstr("cam0/data/100000000.png: its other half of cam0+cam1 was not recorded"));
  EXPECT_THAT(warnings_, HasSubstr("cam1/data/150000000.png: No such file"));
  EXPECT_THAT(warnings_, HasSubstr("cam0/data/200000000.png: begins as no picture"));
  const auto over = (*body)->step({});
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().code, ErrorCode::corrupt);
  EXPECT_THAT(over.error().message, HasSubstr("3 of them dropped"));
}

TEST_F(SeveralSensors, ListsAndCalibrationsMayLieBesideTheFolders) {
  record("cam0", 0.25, {50});
  fs::rename(folder_ / "mav0" / "cam0" / "data.csv", folder_ / "cam0_data.csv");
  fs::rename(folder_ / "mav0" / "cam0" / "sensor.yaml", folder_ / "cam0_sensor.yaml");
  auto body = open("cam0");
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_EQ(played(**body), std::vector<std::string>{"50: cam0"});
}

TEST_F(SeveralSensors, AGivenMountMovesTheWholeRig) {
  record("cam0", 0.25, {50});
  record("cam1", 0.05, {50});
  ReplayBodyConfig config;
  config.folder = folder_.string();
  config.camera = "cam0+cam1";
  config.robot_from_camera = downward_mount(0.1, 0.0, 0.6, 0.7, 0.0, 0.0);
  const auto body = make_replay_body(config);
  ASSERT_TRUE(body) << body.error().message;
  const Sensor pair = (*body)->rig().sensors.front();
  EXPECT_EQ(pair.gaze(), Gaze::down);
  EXPECT_EQ(pair.camera.robot_from_camera.translation, config.robot_from_camera->translation);
  EXPECT_NEAR((pair.camera.robot_from_camera.inverse() * pair.right->robot_from_camera).translation.x(), 0.2, 1e-9);
}

TEST_F(SeveralSensors, WhatIsNotThereIsNamed) {
  record("cam0", 0.25, {50});
  EXPECT_THAT(open("cam0+cam1").error().message, HasSubstr("cam1/data.csv: missing"));
  EXPECT_THAT(open("cam0,").error().message, HasSubstr("a name is empty"));
  EXPECT_THAT(open("cam0+cam0+cam0").error().message, HasSubstr("LEFT+RIGHT"));
}

}  // namespace
}  // namespace weft::agents::replay
