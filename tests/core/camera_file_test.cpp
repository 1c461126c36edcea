#include "core/camera/camera_file.hpp"

#include <gmock/gmock.h>

namespace weft {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kEuroc = R"(%YAML:1.0
# General sensor definitions.
sensor_type: camera
comment: VI-Sensor cam0 (MT9M034)
T_BS:
  cols: 4
  rows: 4
  data: [0.0, 0.0, 1.0, 0.1,
         -1.0, 0.0, 0.0, 0.2,
         0.0, -1.0, 0.0, 0.3,
         0.0, 0.0, 0.0, 1.0]
rate_hz: 20
resolution: [752, 480]
camera_model: pinhole
intrinsics: [458.654, 457.296, 367.215, 248.375] #fu, fv, cu, cv
distortion_model: radial-tangential
distortion_coefficients: [-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05]
)";

constexpr const char* kChain = R"(cam0:
  cam_overlaps: [1]
  camera_model: pinhole
  distortion_coeffs: [-0.003, 0.0007, -0.002, 0.0004]
  distortion_model: equidistant
  intrinsics: [190.9, 190.8, 254.9, 256.8]
  resolution: [512, 512]
  rostopic: /cam0/image_raw
cam1:
  T_cam_imu:
  - [1.0, 0.0, 0.0, 0.0]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.11]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
  camera_model: pinhole
  distortion_coeffs: [0.1, 0.01, 0.001, 0.0001]
  distortion_model: radtan
  intrinsics: [300.0, 301.0, 320.0, 240.0]
  resolution: [640, 480]
  timeshift_cam_imu: 0.01
)";

constexpr const char* kRos = R"(image_width: 640
image_height: 480
camera_name: narrow_stereo
camera_matrix:
  rows: 3
  cols: 3
  data: [438.783367, 0.000000, 305.593336, 0.000000, 437.302876, 243.738352, 0.000000, 0.000000, 1.000000]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.361976, 0.110510, 0.001014, 0.000505, 0.000000]
rectification_matrix:
  rows: 3
  cols: 3
  data: [0.999978, 0.002789, -0.006046, -0.002816, 0.999986, -0.004401, 0.006034, 0.004417, 0.999972]
projection_matrix:
  rows: 3
  cols: 4
  data: [393.65, 0.0, 322.79, 0.0, 0.0, 393.65, 241.09, 0.0, 0.0, 0.0, 1.0, 0.0]
)";

std::string spoilt(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}
std::string refused(const std::string& text) {
  const auto read = parse_camera_file(text, "cam.yaml", "cam0");
  return read ? "" : read.error().message;
}

TEST(CameraFile, EurocsSensorIsRead) {
  const auto read = parse_camera_file(kEuroc, "cam.yaml", "cam0");
  ASSERT_TRUE(read) << read.error().message;
  const CameraCalibration& camera = read->camera;
  EXPECT_EQ(camera.width, 752);
  EXPECT_EQ(camera.fy, 457.296);
  EXPECT_EQ(camera.lens, LensModel::radtan);
  EXPECT_THAT(camera.distortion, ElementsAre(-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05, 0.0));
  ASSERT_TRUE(camera.body_from_camera);
  EXPECT_NEAR(camera.body_from_camera->translation.z(), 0.3, 1e-12);
  EXPECT_NEAR((camera.body_from_camera->rotation * Eigen::Vector3d::UnitZ()).x(), 1.0, 1e-12);
  EXPECT_TRUE(read->not_understood.empty());
}

TEST(CameraFile, ACameraOfKalibrsChainIsRead) {
  const auto first = parse_camera_file(kChain, "chain.yaml", "cam0");
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(first->camera.lens, LensModel::equidistant);
  EXPECT_THAT(first->camera.distortion, ElementsAre(-0.003, 0.0007, -0.002, 0.0004, 0.0));
  EXPECT_FALSE(first->camera.body_from_camera);
  const auto second = parse_camera_file(kChain, "chain.yaml", "cam1");
  ASSERT_TRUE(second);
  EXPECT_EQ(second->camera.width, 640);
  EXPECT_FALSE(second->camera.body_from_camera);  // an IMU's is not the robot's
  EXPECT_THAT(second->not_understood, ElementsAre("chain.yaml:10: T_cam_imu", "chain.yaml:25: timeshift_cam_imu"));
  EXPECT_FALSE(first->camera.previous_from_camera);
  ASSERT_TRUE(second->camera.previous_from_camera);
  EXPECT_NEAR(second->camera.previous_from_camera->translation.x(), 0.11, 1e-12) << "to the right of the first";
  std::string short_of_a_row = kChain;
  short_of_a_row.replace(short_of_a_row.find("  - [1.0, 0.0, 0.0, -0.11]\n"), 27, "");
  EXPECT_THAT(parse_camera_file(short_of_a_row, "chain.yaml", "cam1").error().message,
              HasSubstr("T_cn_cnm1 must have 4 rows"));
  EXPECT_THAT(parse_camera_file(kChain, "chain.yaml", "cam2").error().message, HasSubstr("it has cam0, cam1"));
}

TEST(CameraFile, RosCameraInfoIsRead) {
  const auto read = parse_camera_file(kRos, "info.yaml", "cam0");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->camera.fx, 438.783367);
  EXPECT_EQ(read->camera.cy, 243.738352);
  EXPECT_EQ(read->camera.distortion[1], 0.110510);
  const std::string fisheye = spoilt(spoilt(kRos, "plumb_bob", "equidistant"), ", 0.000505, 0.000000]", ", 0.0005]");
  EXPECT_EQ(parse_camera_file(fisheye, "info.yaml", "cam0")->camera.lens, LensModel::equidistant);
}

TEST(CameraFile, WhatIsWrittenReadsBackTheSame) {
  CameraCalibration camera = parse_camera_file(kEuroc, "cam.yaml", "cam0")->camera;
  camera.distortion[4] = 1.0 / 3.0;
  camera.sigma.focal_share = 0.0004;
  camera.sigma.scale_share = 0.001;
  const std::string text = camera_file_text(camera, {"made by a test"});
  const auto again = parse_camera_file(text, "again.yaml", "cam0");
  ASSERT_TRUE(again) << again.error().message << text;
  EXPECT_EQ(again->camera.fx, camera.fx);
  EXPECT_EQ(again->camera.distortion, camera.distortion);
  EXPECT_LT(again->camera.body_from_camera->rotation.angularDistance(camera.body_from_camera->rotation), 1e-7);
  EXPECT_EQ(again->camera.sigma.focal_share, 0.0004);
  EXPECT_EQ(again->camera.sigma.scale_share, 0.001);
  EXPECT_FALSE(again->camera.sigma.yaw_rad);
  EXPECT_TRUE(again->not_understood.empty());
}

TEST(CameraFile, WhatIsWrongIsNamedWithItsLineAndBound) {
  EXPECT_THAT(refused(spoilt(kEuroc, "[458.654, 457.296", "[458.654")), HasSubstr("cam.yaml:15: intrinsics must be"));
  EXPECT_THAT(refused(spoilt(kEuroc, "458.654", "-1")), HasSubstr("cam.yaml:15: intrinsics: focal"));
  EXPECT_THAT(refused(spoilt(kEuroc, "367.215", "1e9")), HasSubstr("[-1e+05, 1e+05]"));
  EXPECT_THAT(refused(spoilt(kEuroc, "367.215", "nan")), HasSubstr("cam.yaml:15"));
  EXPECT_THAT(refused(spoilt(kEuroc, "367.215", "900")), HasSubstr("outside the image"));
  EXPECT_THAT(refused(spoilt(kEuroc, "[752, 480]", "[752.5, 480]")), HasSubstr("whole pixels"));
  EXPECT_THAT(refused(spoilt(kEuroc, "pinhole", "omni")), HasSubstr("cam.yaml:14: camera_model"));
  EXPECT_THAT(refused(spoilt(kEuroc, "radial-tangential", "fov")), HasSubstr("'fov' is unknown"));
  EXPECT_THAT(refused(spoilt(kEuroc, "-0.28340811", "-2.8")), HasSubstr("cam.yaml:17: distortion_coefficients: "));
  EXPECT_THAT(refused(spoilt(kEuroc, "-0.28340811", "-2e6")), HasSubstr("[-1e+06, 1e+06]"));
  EXPECT_THAT(refused(spoilt(kEuroc, "-1.0, 0.0, 0.0, 0.2", "-1.0, 0.5, 0.0, 0.2")), HasSubstr("no rotation"));
  EXPECT_THAT(refused(spoilt(kEuroc, "rate_hz: 20", "camera_model: pinhole")), HasSubstr("second time"));
  EXPECT_THAT(refused(spoilt(kEuroc, "resolution", "size")), HasSubstr("the key resolution is missing"));
  EXPECT_THAT(refused(spoilt(kRos, "plumb_bob", "rational_polynomial")), testing::IsEmpty());
  EXPECT_THAT(refused(spoilt(kRos, "305.593336, 0.000000", "305.593336, 0.1")), HasSubstr("camera_matrix must be"));
  EXPECT_THAT(refused("{["), HasSubstr("no YAML"));
  EXPECT_THAT(refused("a: 1"), HasSubstr("no camera"));
  EXPECT_THAT(refused("- 1"), HasSubstr("key: value"));
  EXPECT_THAT(refused(std::string(100000, '#')), HasSubstr("64 KiB"));
}

}  // namespace
}  // namespace weft
