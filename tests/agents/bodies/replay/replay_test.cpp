#include "agents/bodies/replay/replay_body.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "agents/bodies/replay/recording.hpp"
#include "core/random.hpp"
#include "tests/support/raw_png.hpp"

namespace weft::agents::replay {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* kSensor = R"(# a comment
camera_model: pinhole
resolution: [32, 24]
intrinsics: [20.5, 21, 15.5, 11.5]
distortion_model: radial-tangential
distortion_coefficients: [-0.28, 0.07, 0.0002, 0.00002]
T_BS:
  cols: 4
  rows: 4
  data: [0.0, 0.0, 1.0, 0.1,
         -1.0, 0.0, 0.0, 0.2,
         0.0, -1.0, 0.0, 0.3,
         0.0, 0.0, 0.0, 1.0]
)";

class Recording : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              (std::string("weft-replay-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(camera() / "data");
    write("sensor.yaml", kSensor);
    write("data.csv", "#timestamp [ns],filename\n1000000000,a.png\n1050000000,b.png\r\n1100000000,c.png\n");
    for (const char* name : {"a.png", "b.png", "c.png"}) {
      weft::test::write_png(camera() / "data" / name,
                            weft::test::plain_picture(32, 24, static_cast<std::uint8_t>(name[0])));
    }
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path camera() const { return folder_ / "mav0" / "cam0"; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(camera() / name) << text; }
  Result<std::unique_ptr<Body>> open() {
    ReplayBodyConfig config;
    config.folder = folder_.string();
    config.warn = [this](const std::string& text) { warnings_ += text; };
    return make_replay_body(config);
  }

  fs::path folder_;
  std::string warnings_;
};

TEST_F(Recording, PlaysItsImagesAtTheirTimesAndEnds) {
  auto body = open();
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_EQ((*body)->kind(), "replay");
  for (int i = 0; i < 3; ++i) {
    const auto sample = (*body)->step({0.5, 0.0});
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->frame, static_cast<std::uint64_t>(i + 1));
    EXPECT_EQ(sample->time.time_since_epoch().count(), 1000000000 + i * 50000000LL);
    EXPECT_EQ(sample->motion.elapsed.count(), i == 0 ? 0 : 50000000);
    EXPECT_EQ(sample->motion.command, Twist{});
    EXPECT_FALSE(sample->motion.wheels);
    ASSERT_FALSE(sample->views.empty());
    EXPECT_EQ(std::get<Image>(sample->views.front().data).pixels->at(0), 'a' + i);
  }
  const auto over = (*body)->step({});
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().code, ErrorCode::unavailable);
  EXPECT_THAT(over.error().message, HasSubstr("recording is over"));
}

TEST_F(Recording, GivesItsSensorsCalibration) {
  const Rig rig = (*open())->rig();
  ASSERT_EQ(rig.sensors.size(), 1U);
  EXPECT_EQ(rig.sensors[0].id, "cam0");
  EXPECT_EQ(rig.camera().width, 32);
  EXPECT_EQ(rig.camera().fx, 20.5);
  EXPECT_EQ(rig.camera().distortion[1], 0.07);
  EXPECT_NEAR(rig.camera().robot_from_camera.translation.z(), 0.3, 1e-12);
  EXPECT_NEAR((rig.camera().robot_from_camera.rotation * Eigen::Vector3d::UnitZ()).x(), 1.0, 1e-12);
}

TEST_F(Recording, ADamagedImageIsADroppedFrameAndNamed) {
  std::ofstream(camera() / "data" / "b.png") << "not a picture";
  auto body = open();
  EXPECT_FALSE((*body)->step({})->views.empty());
  const auto sample = (*body)->step({});
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->views.empty());
  EXPECT_THAT(warnings_, HasSubstr("b.png"));
  EXPECT_FALSE((*body)->step({})->views.empty());
  const auto over = (*body)->step({});
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().code, ErrorCode::corrupt);
  EXPECT_THAT(over.error().message, HasSubstr("over after 3 images, 1 of them dropped"));
}

TEST_F(Recording, ATruncatedImageIsADroppedFrame) {
  images::Picture noise = weft::test::plain_picture(32, 24, 0);
  Random random(1);
  for (std::uint8_t& sample : noise.samples) sample = static_cast<std::uint8_t>(random.next());
  const fs::path path = camera() / "data" / "b.png";
  weft::test::write_png(path, noise);
  fs::resize_file(path, fs::file_size(path) / 2);
  auto body = open();
  (void)(*body)->step({});
  EXPECT_TRUE((*body)->step({})->views.empty());
  EXPECT_THAT(warnings_, HasSubstr("b.png"));
}

TEST_F(Recording, AnImageOfAnotherSizeIsADroppedFrame) {
  weft::test::write_png(camera() / "data" / "a.png", weft::test::plain_picture(10, 10, 1));
  auto body = open();
  EXPECT_TRUE((*body)->step({})->views.empty());
  EXPECT_THAT(warnings_, HasSubstr("10 x 10"));
}

TEST_F(Recording, WithoutAListNamesAreTimes) {
  fs::remove(camera() / "data.csv");
  EXPECT_EQ(open().error().code, ErrorCode::invalid);
  EXPECT_THAT(open().error().message, HasSubstr("without a data.csv its name must be its time in nanoseconds"));
  fs::rename(camera() / "data/a.png", camera() / "data/2000000000.png");
  fs::rename(camera() / "data/b.png", camera() / "data/950000000.png");
  fs::rename(camera() / "data/c.png", camera() / "data/2050000000.png");
  auto body = open();
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_NEAR(seconds((*body)->step({})->time.time_since_epoch()), 0.95, 1e-9) << "in the order of time";
  EXPECT_NEAR(seconds((*body)->step({})->time.time_since_epoch()), 2.0, 1e-9);
  EXPECT_THAT(warnings_, HasSubstr("data.csv: missing"));
  fs::copy(camera() / "data/2050000000.png", camera() / "data/2050000000.pgm");
  EXPECT_THAT(open().error().message, HasSubstr("another image has the same time"));
  fs::remove_all(camera() / "data");
  EXPECT_EQ(open().error().code, ErrorCode::not_found);
  EXPECT_THAT(open().error().message, HasSubstr("data.csv"));
}

TEST_F(Recording, AMissingSensorIsNamed) {
  fs::remove(camera() / "sensor.yaml");
  const auto body = open();
  ASSERT_FALSE(body);
  EXPECT_THAT(body.error().message, HasSubstr("sensor.yaml"));
}

TEST_F(Recording, HasNoHand) {
  const auto led = (*open())->drive_by_hand({{0.0, 0.0}, {1.0, 0.0}});
  ASSERT_FALSE(led);
  EXPECT_EQ(led.error().code, ErrorCode::refused);
}

TEST_F(Recording, HasTheWheelsThatWereRecorded) {
  fs::create_directories(folder_ / "mav0" / "wheels0");
  std::ofstream(folder_ / "mav0" / "wheels0" / "data.csv")
      << "#time,metres,radians\n1025000000,2.0,0.1\n1075000000,2.1,0.3\n"
         "1125000000,2.3,0.3\n";
  auto body = open();
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_FALSE((*body)->step({})->motion.wheels);
  EXPECT_FALSE((*body)->step({})->motion.wheels) << "the wheels began between the first two images";
  const auto sample = (*body)->step({});
  ASSERT_TRUE(sample->motion.wheels);
  EXPECT_NEAR(sample->motion.wheels->distance_m, 2.2 - 2.05, 1e-12);
  EXPECT_NEAR(sample->motion.wheels->heading_rad, 0.1, 1e-12);
  std::ofstream(folder_ / "mav0" / "wheels0" / "data.csv") << "1,2.0,0.1\n2,2.1\n";
  EXPECT_THAT(open().error().message, HasSubstr("data.csv:2: expected"));
}

TEST(ImageList, NamesTheLineThatIsWrong) {
  for (const char* text : {"1,a.png\nx,b.png\n", "1,a.png\n1,b.png\n", "1,a.png\n2\n", "1,a.png\n2,../b.png\n"}) {
    const auto images = parse_image_list(text, "data.csv");
    ASSERT_FALSE(images) << text;
    EXPECT_THAT(images.error().message, HasSubstr("data.csv:2"));
  }
  EXPECT_FALSE(parse_image_list("# nothing\n", "data.csv"));
}

TEST(Lists, MayBeginWithAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_TRUE(parse_image_list(mark + "1,a.png\n", "data.csv"));
  EXPECT_TRUE(parse_image_list(mark + "#time,file\n1,a.png\n", "data.csv"));
  EXPECT_TRUE(parse_wheels(mark + "1,2.0,0.1\n", "data.csv"));
}

TEST_F(Recording, WhatIsWrongWithItsSensorIsNamed) {
  std::string text = kSensor;
  text.replace(text.find("[20.5, 21, 15.5, 11.5]"), 22, "[20.5]");
  write("sensor.yaml", text);
  EXPECT_THAT(open().error().message, HasSubstr("sensor.yaml:4: intrinsics"));
  text = kSensor;
  write("sensor.yaml", text.substr(0, text.find("T_BS")));
  EXPECT_THAT(open().error().message, HasSubstr("T_BS"));
}

TEST_F(Recording, WhatIsNotUnderstoodOfItsSensorIsNamed) {
  write("sensor.yaml", std::string(kSensor) + "timeshift_cam_imu: 0.01\n");
  ASSERT_TRUE(open());
  EXPECT_THAT(warnings_, HasSubstr("sensor.yaml:14: timeshift_cam_imu is not understood"));
}

}  // namespace
}  // namespace weft::agents::replay
