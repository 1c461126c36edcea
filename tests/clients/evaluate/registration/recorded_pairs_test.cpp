// Recorded clouds, where they are: WEFT_DATA names the folder that holds point-clouds.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "clients/evaluate/registration/pair_study.hpp"

namespace weft::evaluate::registration {
namespace {

namespace fs = std::filesystem;

class RecordedPairs : public testing::Test {
 protected:
  void SetUp() override {
    const char* named = std::getenv("WEFT_DATA");
    data_ = fs::path(named != nullptr ? named : WEFT_DATA_BESIDE) / "point-clouds";
    if (!fs::exists(data_))
      GTEST_SKIP() << "SKIPPED: no clouds at " << data_ << "; set WEFT_DATA to the folder that holds point-clouds";
  }
  void expect_met(const RegisterOptions& options) const {
    std::ostringstream out;
    std::ostringstream progress;
    const Surroundings around{out, progress, [] { return 0.0; }, [] { return false; }};
    const Result<Ended> ended = study_pair(options, around, [] { return 0.0; });
    ASSERT_TRUE(ended) << ended.error().message;
    EXPECT_EQ(*ended, Ended::complete) << out.str();
  }
  fs::path data_;
};

TEST_F(RecordedPairs, OfALidarAreWithinTheirBoundsOfTheTruth) {
  const fs::path lidar = data_ / "small_gicp";
  expect_met({lidar / "target.ply", lidar / "source.ply", lidar / "T_target_source.txt", "", false});
}

TEST_F(RecordedPairs, OfAKinectAreNearWhatPclSays) {
  const fs::path kinect = data_ / "pcl";
  expect_met({kinect / "capture0001.pcd", kinect / "capture0002.pcd", "", "", false});
}

TEST_F(RecordedPairs, OfARoomAreNearWhatPclSays) {
  const fs::path room = data_ / "pcl";
  expect_met({room / "room_scan1.pcd", room / "room_scan2.pcd", "", "1.79387,0.720047,0,0.6931", false});
}

}  // namespace
}  // namespace weft::evaluate::registration
