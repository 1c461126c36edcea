#include "clients/evaluate/disturbances/score.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::evaluate {
namespace {

/// Returns a drive straight ahead at half a metre a second, 30 frames a second; odometry says `scale` times as much.
std::vector<Frame> straight(double metres, double scale, double stamps = 1.0) {
  std::vector<Frame> run;
  for (int i = 0; 0.5 * i / 30.0 <= metres; ++i) {
    const double t = i / 30.0;
    run.push_back({{0.5 * t, 1.0, 0.0}, t, {0.5 * t * scale, 0.0, 0.0}, t * stamps, i > 0});
  }
  return run;
}

TEST(Score, PerfectOdometryCostsNothing) {
  const Score score = score_of({straight(12.0, 1.0)}, {});
  EXPECT_NEAR(score.speed_error_mm_s, 0.0, 1e-6);
  EXPECT_NEAR(score.drift_mm, 0.0, 1e-6);
  EXPECT_NEAR(score.drift_deg, 0.0, 1e-6);
}

TEST(Score, AScaleErrorIsSpeedAndDrift) {
  const Score score = score_of({straight(12.0, 1.02)}, {});
  EXPECT_NEAR(score.speed_error_mm_s, 10.0, 0.01);
  EXPECT_NEAR(score.drift_mm, 200.0, 1.0);
}

TEST(Score, WrongStampsAreSpeedButNoDrift) {
  const Score score = score_of({straight(12.0, 1.0, 1.0 / 1.02)}, {});
  EXPECT_NEAR(score.speed_error_mm_s, 10.0, 0.01);
  EXPECT_NEAR(score.drift_mm, 0.0, 1e-6);
}

TEST(Score, LessThanTenMetresHaveNoDrift) {
  EXPECT_TRUE(std::isnan(score_of({straight(9.0, 1.0)}, {}).drift_mm));
}

TEST(Score, BlindSamplesAreCounted) {
  EXPECT_NEAR(score_of({straight(1.0, 1.0)}, {}).blind_percent, 100.0 / 61.0, 1e-9);
}

TEST(Score, FixesAreJudgedByTheTruth) {
  const Pose2 here{0.1, 0.0, 0.0};
  const std::vector<Attempt> attempts = {{here, true, {0.11, 0.0, 0.0}},  // right, 10 mm
                                         {here, true, {0.16, 0.0, 0.0}},  // wrong, 60 mm
                                         {here, true, {0.1, 0.0, 0.04}},  // wrong, 2.3 degrees
                                         {here, false, {}}};
  const Score score = score_of({}, attempts);
  EXPECT_NEAR(score.fixes_percent, 25.0, 1e-9);
  EXPECT_EQ(score.wrong_fixes, 2.0);
  EXPECT_NEAR(score.fix_mm, 10.0, 1e-6);
  EXPECT_NEAR(score.fix_95_mm, 60.0, 1e-6);
}

TEST(Score, NothingMeasuredIsNothingClaimed) {
  const Score score = score_of({}, {});
  EXPECT_TRUE(std::isnan(score.fixes_percent));
  EXPECT_TRUE(std::isnan(score.fix_mm));
  EXPECT_TRUE(std::isnan(score.speed_error_mm_s));
  EXPECT_TRUE(std::isnan(score.blind_percent));
}

}  // namespace
}  // namespace weft::evaluate
