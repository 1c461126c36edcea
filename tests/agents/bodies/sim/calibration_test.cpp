#include "agents/bodies/sim/calibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "agents/perception/lens.hpp"
#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

const CameraModel kGiven = given_camera_from(CameraSetup{}, Disturbances{}, "r1", 0);

/// Returns how far a quantity is off in each of many robots.
template <class Off>
std::vector<double> drawn(const Off& off) {
  std::vector<double> all;
  for (std::uint64_t seed = 1; seed <= 4000; ++seed)
    all.push_back(off(true_camera_from(kGiven, Disturbances{}, 0.0, Random(seed))));
  return all;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double share_beyond(const std::vector<double>& values, double bound) {
  return static_cast<double>(
             std::count_if(values.begin(), values.end(), [bound](double value) { return std::abs(value) > bound; })) /
         static_cast<double>(values.size());
}

TEST(SimCalibration, ErrorsHaveTheStatedRms) {
  const Disturbances stated;
  const Pose3& mount = kGiven.robot_from_camera;
  EXPECT_NEAR(rms(drawn([](const CameraModel& real) { return real.fx / kGiven.fx - 1.0; })), stated.focal_error,
              0.1 * stated.focal_error);
  EXPECT_NEAR(rms(drawn([](const CameraModel& real) { return real.cx - kGiven.cx; })), stated.centre_error_px, 0.1);
  EXPECT_NEAR(rms(drawn([](const CameraModel& real) { return real.cy - kGiven.cy; })), stated.centre_error_px, 0.1);
  EXPECT_NEAR(rms(drawn([&](const CameraModel& real) {
                return (real.robot_from_camera.translation - mount.translation).norm();
              })),
              stated.mount_error_m, 0.1 * stated.mount_error_m);
  EXPECT_NEAR(rms(drawn([&](const CameraModel& real) {
                return real.robot_from_camera.rotation.angularDistance(mount.rotation);
              })),
              stated.mount_error_rad, 0.1 * stated.mount_error_rad);
}

TEST(SimCalibration, TheLensErrsInTheImagesCornerAsStated) {
  const Eigen::Vector2d corner = normalised_from_pixel(kGiven, {751.0, 479.0});
  const auto off = drawn([&](const CameraModel& real) {
    CameraModel lens = kGiven;
    lens.distortion = real.distortion;
    return (pixel_from_normalised(lens, corner) - pixel_from_normalised(kGiven, corner)).norm();
  });
  EXPECT_NEAR(rms(off), Disturbances{}.distortion_error_px, 0.05);
}

TEST(SimCalibration, ErrorsHaveTailsAndNoneIsBeyondFiveSigma) {
  const double sigma = Disturbances{}.focal_error;
  const auto off = drawn([](const CameraModel& real) { return real.fx / kGiven.fx - 1.0; });
  EXPECT_GT(share_beyond(off, 3.0 * sigma), 0.006) << "normal errors: 0.0027";
  EXPECT_LT(share_beyond(off, 1.0 * sigma), 0.27) << "normal errors: 0.32";
  EXPECT_EQ(share_beyond(off, 5.0 * sigma), 0.0);
}

TEST(SimCalibration, TheAgentIsToldTheSizesOfTheErrors) {
  Disturbances stated;
  stated.focal_error = 0.004;
  stated.mount_error_m = 0.006;
  const CalibrationSigma sigma = given_camera_from(CameraSetup{}, stated, "r1", 0).sigma;
  EXPECT_EQ(sigma.focal_share, 0.004);
  EXPECT_EQ(sigma.centre_px, stated.centre_error_px);
  EXPECT_EQ(sigma.distortion_px, stated.distortion_error_px);
  EXPECT_NEAR(*sigma.height_m, 0.006 / std::sqrt(3.0), 1e-12) << "one axis of three";
  EXPECT_FALSE(sigma.scale_share) << "nobody has measured a drive";
}

TEST(SimCalibration, ABodyThatSinksCarriesItsCameraDown) {
  const CameraModel real = true_camera_from(kGiven, Disturbances{}, 0.0, Random(5));
  const CameraModel sunk = true_camera_from(kGiven, Disturbances{}, 0.01, Random(5));
  EXPECT_NEAR(real.robot_from_camera.translation.z() - sunk.robot_from_camera.translation.z(), 0.01, 1e-12);
}

}  // namespace
}  // namespace weft::agents::sim
