#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/pose3.hpp"
#include "core/result.hpp"

namespace weft {

/// How a lens bends rays. Stored in contents: values are frozen.
enum class LensModel : std::uint8_t {
  radtan = 0,       ///< radial-tangential (Brown), OpenCV's order k1 k2 p1 p2 k3
  equidistant = 1,  ///< Kannala & Brandt 2006 with four coefficients, OpenCV's fisheye: k1 k2 k3 k4
};
const char* to_string(LensModel lens);

/// How well a calibration is known, one standard deviation each; none: nobody has said.
struct CalibrationSigma {
  std::optional<double> focal_share;  ///< of the focal length
  std::optional<double> tilt_rad;     ///< of the mount's pitch and roll
  std::optional<double> yaw_rad;
  std::optional<double> scale_share;  ///< of distances over the floor: height and focal length together
};

/// A camera as a file describes it; pixels, the centre of the first one at (0, 0).
struct CameraCalibration {
  int width = 0, height = 0;
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;
  LensModel lens = LensModel::radtan;
  std::array<double, 5> distortion{};     ///< in the lens model's order; what it does not have is 0
  std::optional<Pose3> body_from_camera;  ///< none: the file does not say how the camera is mounted
  CalibrationSigma sigma;
};

struct CameraFile {
  CameraCalibration camera;
  std::vector<std::string> not_understood;  ///< "file:line: key", of what was passed over
};

/// A camera's YAML file: EuRoC's or Kalibr's sensor.yaml, Kalibr's camera chain (`camera` says which of it), or ROS's
/// camera_info (docs/formats/camera.md). invalid: file, line, key and bound of what is wrong or unknown to us.
Result<CameraFile> parse_camera_file(std::string_view text, std::string_view file, std::string_view camera);

/// The same as a sensor.yaml that EuRoC's and Kalibr's readers take, `remarks` above it as comments.
std::string camera_file_text(const CameraCalibration& camera, const std::vector<std::string>& remarks);

}  // namespace weft
