#include "agents/bodies/replay/kitti.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "agents/bodies/replay/replay_body.hpp"
#include "tests/support/raw_png.hpp"

namespace weft::agents::replay {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* kLeft = "700 0 15.5 0 0 700 11.5 0 0 0 1 0";
constexpr const char* kRight = "700 0 15.5 -350 0 700 11.5 0 0 0 1 0";

TEST(KittiProjection, IsByNameOrByOrder) {
  for (const std::string& text :
       {std::string(kLeft) + "\n" + kRight + "\n", "P1: " + std::string(kRight) + "\nP0: " + kLeft + "\n"}) {
    const auto right = parse_projection(text, "calib.txt", 1);
    ASSERT_TRUE(right) << right.error().message;
    EXPECT_EQ(right->focal_px, 700.0);
    EXPECT_EQ(right->cx, 15.5);
    EXPECT_EQ(right->cy, 11.5);
    EXPECT_EQ(right->baseline_m, 0.5);
    EXPECT_EQ(parse_projection(text, "calib.txt", 0)->baseline_m, 0.0);
  }
}

TEST(KittiProjection, WhatIsNoneIsNamedWithItsLine) {
  const auto said = [](const std::string& text) { return parse_projection(text, "calib.txt", 0).error().message; };
  EXPECT_THAT(said("# a remark: of its author\n"), HasSubstr("calib.txt: has no projection P0"));
  EXPECT_THAT(said("P0: 1 2 3\n"), HasSubstr("calib.txt:1: P0 must have 12 numbers"));
  EXPECT_THAT(said(std::string("\n") + kLeft + " 13\n"), HasSubstr("calib.txt:2: P0 must have 12 numbers"));
  EXPECT_THAT(said("-700 0 15.5 0 0 -700 11.5 0 0 0 1 0\n"), HasSubstr("rectified camera"));
  EXPECT_THAT(said("700 1 15.5 0 0 700 11.5 0 0 0 1 0\n"), HasSubstr("rectified camera"));
}

class KittiRecording : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              (std::string("weft-kitti-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    for (const char* half : {"image_l", "image_r"}) {
      fs::create_directories(folder_ / half);
      for (const char* name : {"000000.png", "000001.png"})
        weft::test::write_png(folder_ / half / name,
                              weft::test::plain_picture(32, 24, static_cast<std::uint8_t>(half[6])));
    }
    std::ofstream(folder_ / "calib.txt") << kLeft << "\n" << kRight << "\n";
    config_.folder = folder_.string();
    config_.camera = "image_l+image_r";
    config_.robot_from_camera = downward_mount(0.3, 0.0, 1.6, 0.0, 0.0, 0.0);
    config_.warn = [this](const std::string& text) { warnings_ += text + "\n"; };
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
  ReplayBodyConfig config_;
  std::string warnings_;
};

TEST_F(KittiRecording, IsAPairHalfAMetreWide) {
  auto body = make_replay_body(config_);
  ASSERT_TRUE(body) << body.error().message;
  const Sensor pair = (*body)->rig().sensors.front();
  EXPECT_EQ(pair.kind, SensorKind::stereo);
  EXPECT_EQ(pair.gaze(), Gaze::ahead);
  EXPECT_EQ(pair.camera.fx, 700.0);
  EXPECT_NEAR((pair.camera.robot_from_camera.inverse() * pair.right->robot_from_camera).translation.x(), 0.5, 1e-9);
  const auto first = (*body)->step({});
  EXPECT_EQ(std::get<StereoPair>(first->views.front().data).right.pixels->at(0), 'r');
  const auto second = (*body)->step({});
  EXPECT_NEAR(seconds(second->motion.elapsed), 0.1, 1e-9);
  EXPECT_THAT(warnings_, HasSubstr("times.txt: missing; taken as ten images a second"));
}

TEST_F(KittiRecording, HasTheTimesThatItSays) {
  std::ofstream(folder_ / "times.txt") << "0.5\n0.7\n";
  auto body = make_replay_body(config_);
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_NEAR(seconds((*body)->step({})->time.time_since_epoch()), 0.5, 1e-9);
  EXPECT_NEAR(seconds((*body)->step({})->motion.elapsed), 0.2, 1e-9);
  EXPECT_EQ(warnings_, "");
  std::ofstream(folder_ / "times.txt") << "0.5\n0.4\n";
  EXPECT_THAT(make_replay_body(config_).error().message, HasSubstr("times.txt:2: expected seconds that increase"));
  std::ofstream(folder_ / "times.txt") << "0.5\n";
  EXPECT_THAT(make_replay_body(config_).error().message, HasSubstr("has 1 times and none for image 1"));
}

TEST_F(KittiRecording, AMissingImageLeavesItsOtherHalfAloneAndNoOther) {
  for (const char* half : {"image_l", "image_r"})
    weft::test::write_png(folder_ / half / "000002.png",
                          weft::test::plain_picture(32, 24, static_cast<std::uint8_t>(half[6] + 2)));
  fs::remove(folder_ / "image_r" / "000001.png");
  std::ofstream(folder_ / "times.txt") << "0.5\n0.7\n0.9\n";
  auto body = make_replay_body(config_);
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_EQ((*body)->step({})->views.size(), 1U);
  EXPECT_TRUE((*body)->step({})->views.empty());
  EXPECT_THAT(warnings_, HasSubstr("000001.png: its other half"));
  const auto third = (*body)->step({});
  ASSERT_EQ(third->views.size(), 1U);
  const auto& pair = std::get<StereoPair>(third->views.front().data);
  EXPECT_EQ(pair.left.pixels->at(0), 'l' + 2);
  EXPECT_EQ(pair.right.pixels->at(0), 'r' + 2);
}

TEST_F(KittiRecording, AnImageWithoutANumberIsNamed) {
  std::ofstream(folder_ / "image_l" / "notes.txt") << "x";
  EXPECT_THAT(make_replay_body(config_).error().message, HasSubstr("notes.txt: expected a number as its name"));
}

TEST_F(KittiRecording, AWrongHalfAndAMissingMountAreNamed) {
  config_.camera = "cam0";
  EXPECT_THAT(make_replay_body(config_).error().message, HasSubstr("it has image_l and image_r"));
  config_.camera = "image_l";
  config_.robot_from_camera.reset();
  EXPECT_THAT(make_replay_body(config_).error().message, HasSubstr("how camera image_l is mounted"));
}

}  // namespace
}  // namespace weft::agents::replay
