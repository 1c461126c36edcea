#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/camera/lens.hpp"
#include "core/geometry/pose3.hpp"
#include "core/result.hpp"

namespace weft {

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
  std::array<double, 3> divisor{};        ///< k4 k5 k6 of a rational lens
  std::optional<Pose3> body_from_camera;  ///< none: the file does not say how the camera is mounted
  CalibrationSigma sigma;
};

struct CameraFile {
  CameraCalibration camera;
  std::vector<std::string> not_understood;  ///< "file:line: key", of what was passed over
};

/// A camera's YAML file: EuRoC's or Kalibr's sensor.yaml, Kalibr's camera chain (`camera` says which of it), or ROS's
/// camera_info, a file or a printed message (docs/formats/camera.md). invalid: file, line, key and bound of what is
/// wrong or unknown to us; a lens that is not monotone over the image.
Result<CameraFile> parse_camera_file(std::string_view text, std::string_view file, std::string_view camera);

/// The same as a sensor.yaml that EuRoC's and Kalibr's readers take (a rational lens they do not know), `remarks`
/// above it as comments.
std::string camera_file_text(const CameraCalibration& camera, const std::vector<std::string>& remarks);

}  // namespace weft
