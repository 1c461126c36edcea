#include "agents/methods/floor/calibration_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

/// Returns settings of a camera of which nothing is off but what a test says.
FloorConfig exact() {
  FloorConfig config;
  config.focal_share = config.centre_px = config.distortion_px = 1e-7;
  config.mount_yaw_rad = config.mount_position_m = config.mount_height_m = 1e-6;
  return config;
}

Eigen::Vector3d sigmas(const FloorConfig& config, const Pose2& moved,
                       const Eigen::Matrix2d& tilt = Eigen::Matrix2d::Zero()) {
  const PlanarErrors errors = CalibrationErrors(config, test::paper_camera()).of(moved, tilt);
  return errors.rowwise().norm();
}

const Pose2 kMetre{1.0, 0.0, 0.0};
const Pose2 kTurn{0.0, 0.0, 0.1};

TEST(CalibrationErrors, AHeightIsAShareOfAllDistances) {
  FloorConfig config = exact();
  const double height_m = test::paper_camera().robot_from_camera.translation.z();
  config.mount_height_m = 0.01 * height_m;
  EXPECT_NEAR(sigmas(config, kMetre).x(), 0.01, 0.0005);
  EXPECT_LT(sigmas(config, kMetre).y(), 0.0005);
  EXPECT_LT(sigmas(config, kTurn).z(), 0.0001);
}

TEST(CalibrationErrors, AHeadingOfTheMountLeadsAside) {
  FloorConfig config = exact();
  config.mount_yaw_rad = 0.01;
  EXPECT_NEAR(sigmas(config, kMetre).y(), 0.01, 0.0005);
  EXPECT_LT(sigmas(config, kMetre).x(), 0.0005);
}

TEST(CalibrationErrors, APlaceOfTheMountShiftsTurnsAlone) {
  FloorConfig config = exact();
  config.mount_position_m = 0.01;
  EXPECT_NEAR(sigmas(config, kTurn).x(), 0.001, 0.0001);
  EXPECT_NEAR(sigmas(config, kTurn).y(), 0.001, 0.0001);
  EXPECT_LT(sigmas(config, kMetre).x(), 0.0001);
}

TEST(CalibrationErrors, AFocalLengthIsOffInDistancesAndTurns) {
  FloorConfig config = exact();
  config.focal_share = 0.003;
  EXPECT_GT(sigmas(config, kMetre).x(), 0.0002) << "the tilt that is found with it makes up for most";
  EXPECT_GT(sigmas(config, kTurn).z(), 0.1 * 0.0003);
}

TEST(CalibrationErrors, ALensBendsStraightWaysOrTheirScale) {
  FloorConfig config = exact();
  config.distortion_px = 1.0;
  EXPECT_GT(sigmas(config, kMetre).norm(), 0.0005);
}

TEST(CalibrationErrors, WhatWasMeasuredHoldsInsteadOfWhatFollows) {
  FloorConfig config;
  config.measured_scale = 0.001;
  config.measured_heading_rad = 0.0007;
  EXPECT_NEAR(sigmas(config, kMetre).x(), 0.001, 0.0001);
  EXPECT_NEAR(sigmas(config, kMetre).y(), 0.0007, 0.0001);
  EXPECT_GT(sigmas(config, kTurn).z(), 0.1 * 0.0003) << "a turn tells of the focal length what a distance does not";
  config.measured_scale = 0.03;
  EXPECT_NEAR(sigmas(config, kMetre).x(), 0.03, 0.001) << "by wheels that are known worse than the camera";
}

TEST(CalibrationErrors, ATiltThatIsNotKnownIsAnErrorOfScale) {
  const double known = sigmas(exact(), kMetre).x();
  const double unknown = sigmas(exact(), kMetre, 0.005 * 0.005 * Eigen::Matrix2d::Identity()).x();
  EXPECT_LT(known, 0.0001);
  EXPECT_GT(unknown, 0.0005) << "each fit finds most of it, within what vibration may be";
}

TEST(CalibrationErrors, GrowWithTheMotion) {
  const FloorConfig config;
  EXPECT_NEAR(sigmas(config, {2.0, 0.0, 0.0}).x(), 2.0 * sigmas(config, kMetre).x(), 1e-9);
  EXPECT_EQ(sigmas(config, Pose2{}).norm(), 0.0);
}

TEST(CalibrationErrors, WhatACalibrationStatesTakesThePlaceOfSettingsThatWereNotSet) {
  FloorConfig config;
  CalibrationSigma known;
  EXPECT_EQ(informed(config, known).measured_scale, 0.0);
  known.tilt_rad = 0.002;
  known.scale_share = 0.0015;
  known.yaw_rad = 0.004;
  known.focal_share = 0.0005;
  known.centre_px = 0.3;
  EXPECT_EQ(informed(config, known).mount_tilt_rad, 0.002);
  EXPECT_EQ(informed(config, known).measured_scale, 0.0015);
  EXPECT_EQ(informed(config, known).measured_heading_rad, 0.004);
  EXPECT_EQ(informed(config, known).focal_share, 0.0005);
  EXPECT_EQ(informed(config, known).centre_px, 0.3);
  EXPECT_EQ(informed(config, known).distortion_px, config.distortion_px) << "not stated";
  config.measured_scale = 0.02;
  EXPECT_EQ(informed(config, known).measured_scale, 0.02) << "set by hand";
}

}  // namespace
}  // namespace weft::agents
