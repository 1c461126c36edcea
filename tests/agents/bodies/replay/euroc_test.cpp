// Against the real recording, where it is there: WEFT_DATA names the folder that holds euroc-mh01-600.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "agents/bodies/replay/replay_body.hpp"

namespace weft::agents::replay {
namespace {

namespace fs = std::filesystem;

class Euroc : public testing::Test {
 protected:
  void SetUp() override {
    const char* named = std::getenv("WEFT_DATA");
    const fs::path data = fs::path(named != nullptr ? named : WEFT_DATA_BESIDE) / "euroc-mh01-600";
    if (!fs::exists(data)) {
      GTEST_SKIP() << "SKIPPED: no recording at " << data << "; set WEFT_DATA to the folder that holds it";
    }
    // This copy keeps its lists beside mav0: a folder as EuRoC lays it out, of links.
    folder_ = fs::temp_directory_path() /
              (std::string("weft-euroc-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    const fs::path camera = folder_ / "mav0" / "cam0";
    fs::create_directories(camera / "data");
    fs::create_symlink(fs::absolute(data / "cam0_data.csv"), camera / "data.csv");
    fs::create_symlink(fs::absolute(data / "cam0_sensor.yaml"), camera / "sensor.yaml");
    for (const auto& image : fs::directory_iterator(data / "mav0" / "cam0" / "data")) {
      fs::create_symlink(fs::absolute(image.path()), camera / "data" / image.path().filename());
    }
    damaged_ = fs::absolute(data / "DAMAGED_cam1_1403636592913555456.png");
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
  fs::path damaged_;
};

TEST_F(Euroc, PlaysToItsEnd) {
  ReplayBodyConfig config;
  config.folder = folder_.string();
  std::string warnings;
  config.warn = [&](const std::string& text) { warnings += text; };
  auto body = make_replay_body(config);
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_NEAR((*body)->rig().camera().fx, 458.654, 1e-9);
  int frames = 0;
  SensorTime first{};
  SensorTime last{};
  for (;;) {
    const auto sample = (*body)->step({});
    if (!sample) {
      EXPECT_EQ(sample.error().code, ErrorCode::unavailable);
      break;
    }
    EXPECT_FALSE(sample->views.empty());
    first = frames++ == 0 ? sample->time : first;
    last = sample->time;
  }
  EXPECT_EQ(frames, 112);
  EXPECT_NEAR(seconds(last - first), 111 * 0.05, 0.01);
  EXPECT_EQ(warnings, "");
}

TEST_F(Euroc, ADamagedImageIsDroppedAndNamed) {
  const fs::path victim = folder_ / "mav0" / "cam0" / "data" / "1403636584813555456.png";
  fs::remove(victim);
  fs::create_symlink(damaged_, victim);
  ReplayBodyConfig config;
  config.folder = folder_.string();
  std::string warnings;
  config.warn = [&](const std::string& text) { warnings += text; };
  auto body = make_replay_body(config);
  ASSERT_TRUE(body);
  EXPECT_FALSE((*body)->step({})->views.empty());
  EXPECT_TRUE((*body)->step({})->views.empty());
  EXPECT_THAT(warnings, testing::HasSubstr("1403636584813555456.png"));
}

}  // namespace
}  // namespace weft::agents::replay
