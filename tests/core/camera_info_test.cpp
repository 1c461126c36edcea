// What ROS writes of a camera: a file of its calibration, and a message as it is printed.
#include <gmock/gmock.h>

#include "core/camera/camera_file.hpp"

namespace weft {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string file_with(const std::string& model, const std::string& coefficients, const std::string& more = "") {
  return "image_width: 752\nimage_height: 480\ncamera_name: cam\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
         "  data: [460, 0, 376, 0, 460, 240, 0, 0, 1]\ndistortion_model: " +
         model + "\ndistortion_coefficients:\n  rows: 1\n  data: " + coefficients + "\n" + more;
}

std::string message_with(const std::string& model, const std::string& coefficients, const std::string& more = "") {
  return "header:\n  seq: 7\n  frame_id: cam\nheight: 480\nwidth: 752\ndistortion_model: " + model +
         "\nD: " + coefficients +
         "\nK: [460.0, 0.0, 376.0, 0.0, 460.0, 240.0, 0.0, 0.0, 1.0]\nR: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"
         "P: [460, 0, 376, 0, 0, 460, 240, 0, 0, 0, 1, 0]\n" +
         more;
}

CameraCalibration taken_from(const std::string& text) {
  const auto read = parse_camera_file(text, "info.yaml", "cam0");
  EXPECT_TRUE(read) << (read ? "" : read.error().message) << "\n" << text;
  EXPECT_TRUE(!read || read->not_understood.empty());
  return read ? read->camera : CameraCalibration{};
}

std::string refusal_of(const std::string& text) {
  const auto read = parse_camera_file(text, "info.yaml", "cam0");
  return read ? "" : read.error().message;
}

TEST(CameraInfo, MayHaveNoCoefficients) {
  for (const char* const model : {"plumb_bob", "rational_polynomial", "none", "\"\""}) {
    const CameraCalibration camera = taken_from(file_with(model, "[]"));
    EXPECT_THAT(camera.distortion, ElementsAre(0, 0, 0, 0, 0)) << model;
    EXPECT_EQ(camera.lens, LensModel::radtan);
  }
  EXPECT_EQ(taken_from(file_with("equidistant", "[]")).lens, LensModel::equidistant);
  EXPECT_EQ(taken_from(file_with("plumb_bob", "")).fx, 460.0);
  EXPECT_EQ(taken_from(message_with("\"\"", "[]")).fx, 460.0);
}

TEST(CameraInfo, CoefficientsMayBeLarge) {
  EXPECT_THAT(taken_from(file_with("plumb_bob", "[0.12, -0.45, 0.0004, -0.0003, 1.35]")).distortion,
              ElementsAre(0.12, -0.45, 0.0004, -0.0003, 1.35));
  EXPECT_THAT(taken_from(file_with("equidistant", "[-0.02, 1.9, -3.1, 1.7]")).distortion,
              ElementsAre(-0.02, 1.9, -3.1, 1.7, 0.0));
}

TEST(CameraInfo, CoefficientsThatAModelDoesNotHaveMustBeZero) {
  EXPECT_EQ(
      taken_from(file_with("plumb_bob", "[-0.03, 0.035, -0.0001, -0.0001, -0.012, 0.0, 0.0, 0.0]")).distortion[4],
      -0.012);
  EXPECT_EQ(taken_from(file_with("equidistant", "[0.1, 0, 0, 0, 0]")).distortion[0], 0.1);
  EXPECT_THAT(
      refusal_of(file_with("plumb_bob", "[-0.03, 0.035, 0, 0, 0, 0, 0, 0.1]")),
      HasSubstr("info.yaml:11: distortion_coefficients.data: the number at place 8 must be 0, since plumb_bob "
                "has 5 coefficients"));
  EXPECT_THAT(refusal_of(file_with("rational_polynomial", "[0, 0, 0, 0, 0, 0, 0, 0, 0.1, 0, 0, 0]")),
              HasSubstr("the number at place 9 must be 0"));
  EXPECT_THAT(refusal_of(file_with("plumb_bob", "[0.1, 0.1]")),
              HasSubstr("a list of 4 to 5 numbers, or an empty one"));
  EXPECT_THAT(refusal_of(file_with("\"\"", "[0.1, 0, 0, 0]")), HasSubstr("distortion_model '' is unknown"));
}

TEST(CameraInfo, RationalLensesAreTaken) {
  const CameraCalibration camera =
      taken_from(file_with("rational_polynomial", "[0.31, 0.02, 0.0004, -0.0003, 0.01, 0.38, 0.05, 0.02]"));
  EXPECT_EQ(camera.lens, LensModel::rational);
  EXPECT_THAT(camera.distortion, ElementsAre(0.31, 0.02, 0.0004, -0.0003, 0.01));
  EXPECT_THAT(camera.divisor, ElementsAre(0.38, 0.05, 0.02));
  const auto again = parse_camera_file(camera_file_text(camera, {}), "again.yaml", "cam0");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->camera.lens, LensModel::rational);
  EXPECT_EQ(again->camera.distortion, camera.distortion);
  EXPECT_EQ(again->camera.divisor, camera.divisor);
  EXPECT_EQ(taken_from(file_with("rational_polynomial", "[0.1, 0, 0, 0, 0, 0, 0, 0]")).lens, LensModel::radtan);
}

TEST(CameraInfo, ALensThatFoldsItsImageIsRefused) {
  for (const auto& [model, coefficients] : {std::pair{"plumb_bob", "[-1.5, 0, 0, 0, 0]"},
                                            {"plumb_bob", "[0, 0, 0, 0, -8]"},
                                            {"equidistant", "[-1.2, 0, 0, 0]"},
                                            {"rational_polynomial", "[0, 0, 0, 0, 0, 2, 2, 2]"}}) {
    EXPECT_THAT(
        refusal_of(file_with(model, coefficients)),
        HasSubstr("info.yaml:11: distortion_coefficients.data: the distortion is not monotone over the image"))
        << model << coefficients;
  }
}

TEST(CameraInfo, APrintedMessageIsRead) {
  const CameraCalibration camera =
      taken_from(message_with("plumb_bob", "[-0.1, 0.01, 0.0, 0.0, 0.0]",
                              "binning_x: 0\nbinning_y: 1\nroi:\n  x_offset: 0\n  y_offset: 0\n"
                              "  height: 0\n  width: 0\n  do_rectify: False\n---\n"));
  EXPECT_EQ(camera.width, 752);
  EXPECT_EQ(camera.height, 480);
  EXPECT_EQ(camera.cx, 376.0);
  EXPECT_EQ(camera.distortion[0], -0.1);
  EXPECT_THAT(refusal_of(message_with("plumb_bob", "[0, 0, 0, 0, x]")),
              HasSubstr("info.yaml:7: D: 'x' is no number"));
}

TEST(CameraInfo, JoinedPixelsAndPartsOfAnImageAreRefusedByName) {
  EXPECT_THAT(refusal_of(file_with("plumb_bob", "[]", "binning_x: 2\nbinning_y: 2\n")),
              HasSubstr("info.yaml:12: binning_x must be 0 or 1"));
  EXPECT_THAT(refusal_of(message_with("plumb_bob", "[]", "binning_y: 4\n")), HasSubstr("binning_y must be 0 or 1"));
  EXPECT_THAT(
      refusal_of(file_with("plumb_bob", "[]", "roi:\n  x_offset: 16\n  y_offset: 0\n  width: 640\n  height: 480\n")),
      HasSubstr("roi must be the whole image"));
  EXPECT_EQ(
      taken_from(file_with("plumb_bob", "[]", "roi: {x_offset: 0, y_offset: 0, width: 752, height: 480}\n")).width,
      752);
}

TEST(CameraInfo, MayBeginWithAByteOrderMark) {
  EXPECT_EQ(taken_from("\xEF\xBB\xBF" + file_with("plumb_bob", "[]")).width, 752);
  EXPECT_EQ(taken_from("\xEF\xBB\xBF%YAML:1.0\n" + file_with("plumb_bob", "[]")).width, 752);
}

}  // namespace
}  // namespace weft
