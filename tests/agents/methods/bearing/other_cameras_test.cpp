#include "agents/methods/bearing/other_cameras.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::agents {
namespace {

constexpr double kDataSheet = 0.01;
const ExperienceId kRun{7};
const CameraLook kByView{kRun, {0.02, 1e-6}};

double sigma_of(const FocalShare& share) {
  return std::sqrt(share.variance);
}

TEST(OtherCameras, AreAsTheirDataSheetsSayUntilTheyAreSeen) {
  const FocalShare share = OtherCameras().of(kRun, kDataSheet);
  EXPECT_EQ(share.share, 0.0);
  EXPECT_EQ(sigma_of(share), kDataSheet);
}

TEST(OtherCameras, AreKnownBetterWithEachView) {
  OtherCameras cameras;
  double before = kDataSheet;
  for (int view = 0; view < 8; ++view) {
    cameras.told(kByView, kDataSheet);
    const double now = sigma_of(cameras.of(kRun, kDataSheet));
    EXPECT_LT(now, before);
    before = now;
  }
  EXPECT_NEAR(cameras.of(kRun, kDataSheet).share, kByView.share.share, 2.0 * before);
}

TEST(OtherCameras, AreNeverKnownForSure) {
  OtherCameras cameras;
  for (int view = 0; view < 1000; ++view) cameras.told(kByView, kDataSheet);
  EXPECT_GT(sigma_of(cameras.of(kRun, kDataSheet)), 0.001);
}

/// Shows that one view does not decide, as it may show something else than what was taught.
TEST(OtherCameras, NoViewByItselfDecidesAndManyDo) {
  OtherCameras cameras;
  for (int view = 0; view < 10; ++view) cameras.told({kRun, {0.0, 1e-6}}, kDataSheet);
  cameras.told({kRun, {0.09, 1e-6}}, kDataSheet);
  EXPECT_LT(cameras.of(kRun, kDataSheet).share, 0.004);
  for (int view = 0; view < 60; ++view) cameras.told(kByView, kDataSheet);
  EXPECT_NEAR(cameras.of(kRun, kDataSheet).share, kByView.share.share, 0.003);
}

TEST(OtherCameras, ManyViewsThatTellLittleAreRightInTheEnd) {
  OtherCameras cameras;
  for (int view = 0; view < 500; ++view) cameras.told({kRun, {0.02, 0.01 * 0.01}}, kDataSheet);
  EXPECT_NEAR(cameras.of(kRun, kDataSheet).share, 0.02, 0.001);
}

TEST(OtherCameras, StandHigherByWhatMostOfTheFirstViewsSay) {
  OtherCameras cameras;
  for (const double px : {20.0, -70.0, 22.0, 0.0}) {
    cameras.told(CameraRise{kRun, px});
    EXPECT_FALSE(cameras.rise_px(kRun)) << "too few";
  }
  cameras.told(CameraRise{kRun, 21.0});
  EXPECT_EQ(cameras.rise_px(kRun), 20.0);
  cameras.told(CameraRise{kRun, 50.0});
  EXPECT_EQ(cameras.rise_px(kRun), 20.0) << "cameras are mounted for good";
  EXPECT_FALSE(cameras.rise_px(ExperienceId{8}));
}

TEST(OtherCameras, AreOneForEachRun) {
  OtherCameras cameras;
  cameras.told(kByView, kDataSheet);
  EXPECT_EQ(cameras.of(ExperienceId{8}, kDataSheet).share, 0.0);
  EXPECT_TRUE(cameras.is_due(ExperienceId{8}));
}

TEST(OtherCameras, AViewFromTheSameSpotSaysNothingNew) {
  OtherCameras cameras;
  EXPECT_TRUE(cameras.is_due(kRun));
  cameras.told(kByView, kDataSheet);
  cameras.moved(0.1);
  EXPECT_FALSE(cameras.is_due(kRun));
  cameras.moved(0.25);
  EXPECT_TRUE(cameras.is_due(kRun));
}

TEST(OtherCameras, ThoseNotSeenForLongestGo) {
  OtherCameras cameras;
  constexpr std::uint64_t many = 200;
  for (std::uint64_t run = 1; run <= many; ++run) cameras.told({ExperienceId{run}, kByView.share}, kDataSheet);
  EXPECT_TRUE(cameras.is_due(ExperienceId{1})) << "forgotten";
  EXPECT_FALSE(cameras.is_due(ExperienceId{many}));
}

}  // namespace
}  // namespace weft::agents
