// On pairs that a flying robot has recorded, where they are: WEFT_DATA names the folder that holds euroc-mh01-600.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "agents/bodies/replay/recorded_sensors.hpp"
#include "agents/bodies/replay/replay_body.hpp"
#include "agents/perception/stereo/disparity.hpp"
#include "agents/perception/stereo/rectifier.hpp"
#include "clients/evaluate/stereo/sgbm.hpp"

namespace weft::agents {
namespace {

namespace fs = std::filesystem;

/// Holds every 16th pair of MH_01, rectified. The robot is lifted from half a metre above a pallet.
class RecordedPairs : public testing::Test {
 protected:
  void SetUp() override {
    const char* const named = std::getenv("WEFT_DATA");
    const fs::path folder = fs::path(named != nullptr ? named : WEFT_DATA_BESIDE) / "euroc-mh01-600";
    if (!fs::exists(folder))
      GTEST_SKIP() << "SKIPPED: no recording at " << folder << "; set WEFT_DATA to the folder that holds it";
    const auto sensors = replay::read_sensors({folder.string(), kCameras, {}, {}});
    ASSERT_TRUE(sensors) << sensors.error().message;
    const auto rectifier = Rectifier::make(sensors->front().sensor);
    ASSERT_TRUE(rectifier);
    const auto body = replay::make_replay_body({folder.string(), kCameras, {}, {}});
    ASSERT_TRUE(body) << body.error().message;
    constexpr std::size_t every = 16;
    for (std::size_t i = 0; i < sensors->front().shots.size(); ++i) {
      const auto sample = (*body)->step({});
      ASSERT_TRUE(sample);
      if (i % every != 0 || sample->views.empty()) continue;
      pairs_.push_back(rectifier->rectified(std::get<StereoPair>(sample->views.front().data)));
    }
    ASSERT_EQ(pairs_.size(), 7U);
    config_.disparities = 128;
  }

  static constexpr const char* kCameras = "cam0+cam1";
  std::vector<StereoPair> pairs_;
  DisparityConfig config_;
};

TEST_F(RecordedPairs, AreMatchedWhereThereIsTexture) {
  for (const StereoPair& pair : pairs_) {
    const auto ours = match_disparity(config_, pair);
    ASSERT_TRUE(ours) << ours.error().reason << ": " << ours.error().measured;
    const DisparityMap theirs = evaluate::stereo::sgbm(pair, config_.disparities);
    std::size_t both = 0;
    std::size_t alike = 0;
    for (std::size_t i = 0; i < theirs.sixteenths.size(); ++i) {
      if (ours->sixteenths[i] == DisparityMap::none || theirs.sixteenths[i] == DisparityMap::none) continue;
      ++both;
      alike += std::abs(ours->sixteenths[i] - theirs.sixteenths[i]) <= 16 ? 1U : 0U;
    }
    EXPECT_GT(density(*ours), 0.45);
    EXPECT_GT(both, theirs.sixteenths.size() * 2 / 5);
    EXPECT_GT(alike, both * 86 / 100);
  }
}

TEST_F(RecordedPairs, WithTooFewDisparitiesAreTooNearAndNotDecorrelated) {
  config_.disparities = 48;
  int too_near = 0;
  for (const StereoPair& pair : pairs_) {
    const auto map = match_disparity(config_, pair);
    if (map) continue;
    EXPECT_EQ(map.error().reason, "too_near");
    ++too_near;
  }
  EXPECT_GE(too_near, 4);
}

TEST_F(RecordedPairs, HalvesOfTwoMomentsAreDecorrelated) {
  for (std::size_t i = 0; i + 2 < pairs_.size(); ++i) {
    const auto map = match_disparity(config_, {pairs_[i].left, pairs_[i + 2].right});
    ASSERT_FALSE(map) << "left of pair " << 16 * i << ", density " << density(*map);
    EXPECT_EQ(map.error().reason, "decorrelated") << "left of pair " << 16 * i;
  }
}

}  // namespace
}  // namespace weft::agents
