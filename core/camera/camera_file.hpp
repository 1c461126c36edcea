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

/// Holds the uncertainty of a calibration, one standard deviation each; none: nobody has stated it.
struct CalibrationSigma {
  std::optional<double> focal_share;    ///< of the focal length
  std::optional<double> centre_px;      ///< of the optical centre, across and down each
  std::optional<double> distortion_px;  ///< of where the lens puts a ray that ends in the image's corner
  std::optional<double> tilt_rad;       ///< of the mount's pitch and roll, each
  std::optional<double> yaw_rad;        ///< of the direction in which a robot that drives straight on is seen to go
  std::optional<double> position_m;     ///< of the mount ahead and aside, each
  std::optional<double> height_m;       ///< of the mount
  std::optional<double> scale_share;    ///< of distances driven straight on, all of the above together
};

/// Says how a camera's file names a member of the above (`weft_sigma`), and the largest value that is taken.
struct SigmaKey {
  const char* name;
  std::optional<double> CalibrationSigma::*member;
  double most;
};
inline constexpr std::array<SigmaKey, 8> kSigmaKeys = {{{"focal_share", &CalibrationSigma::focal_share, 1.0},
                                                        {"centre_px", &CalibrationSigma::centre_px, 1000.0},
                                                        {"distortion_px", &CalibrationSigma::distortion_px, 1000.0},
                                                        {"tilt_rad", &CalibrationSigma::tilt_rad, 1.0},
                                                        {"yaw_rad", &CalibrationSigma::yaw_rad, 1.0},
                                                        {"position_m", &CalibrationSigma::position_m, 1.0},
                                                        {"height_m", &CalibrationSigma::height_m, 1.0},
                                                        {"scale_share", &CalibrationSigma::scale_share, 1.0}}};

/// Describes a camera as its file does; in pixels, with the centre of the first one at (0, 0).
struct CameraCalibration {
  int width = 0, height = 0;
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;
  LensModel lens = LensModel::radtan;
  std::array<double, 5> distortion{};     ///< in the lens model's order; what it does not have is 0
  std::array<double, 3> divisor{};        ///< k4 k5 k6 of a rational lens
  std::optional<Pose3> body_from_camera;  ///< none: the file does not say how the camera is mounted
  /// Is the pose in the frame of the camera before it in a Kalibr chain; none: it is the first, or not stated.
  std::optional<Pose3> previous_from_camera = {};
  CalibrationSigma sigma;
};

struct CameraFile {
  CameraCalibration camera;
  std::vector<std::string> not_understood;  ///< "file:line: key", of what was passed over
};

/// Reads a camera's YAML file: EuRoC's or Kalibr's sensor.yaml, Kalibr's camera chain (`camera` says which of it), or
/// ROS's camera_info, a file or a printed message (docs/formats/camera.md). invalid: file, line, key and bound of
/// what is wrong or unknown to us; a lens that is not monotone over the image.
Result<CameraFile> parse_camera_file(std::string_view text, std::string_view file, std::string_view camera);

/// Writes the camera as a sensor.yaml that EuRoC's and Kalibr's readers take (a rational lens they do not know), with
/// `remarks` above it as comments.
std::string camera_file_text(const CameraCalibration& camera, const std::vector<std::string>& remarks);

}  // namespace weft
