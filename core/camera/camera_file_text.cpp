#include <span>
#include <utility>

#include "core/camera/camera_file.hpp"
#include "core/camera/number_text.hpp"

namespace weft {
namespace {

std::string list(std::span<const double> values) {
  std::string out = "[";
  for (const double value : values) out += (out.size() > 1 ? ", " : "") + number_text(value);
  return out + "]";
}

std::string mount_text(const Pose3& body_from_camera) {
  const Eigen::Matrix3d rotation = body_from_camera.rotation.toRotationMatrix();
  std::string out =
      "# takes the camera's points (x right, y down, z ahead) to the robot's (x ahead, y left, z up)\n"
      "T_BS:\n  rows: 4\n  cols: 4\n  data: [";
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) out += number_text(rotation(row, column)) + ", ";
    out += number_text(body_from_camera.translation[row]) + ",\n         ";
  }
  return out + "0, 0, 0, 1]\n";
}

std::string sigma_text(const CalibrationSigma& sigma) {
  std::string out;
  for (const auto& [key, member, most] : kSigmaKeys) {
    const std::optional<double>& value = sigma.*member;
    if (value.has_value()) out += std::string("  ") + key + ": " + number_text(*value) + "\n";
  }
  return out.empty() ? out : "# one standard deviation each\nweft_sigma:\n" + out;
}

/// Writes model, coefficients and their names as the file's reader takes them again.
std::string lens_text(const CameraCalibration& camera) {
  const auto& k = camera.distortion;
  if (camera.lens == LensModel::rational) {
    const auto& [k4, k5, k6] = camera.divisor;
    return "distortion_model: rational_polynomial\ndistortion_coefficients: " +
           list(std::array{k[0], k[1], k[2], k[3], k[4], k4, k5, k6}) + "  # k1 k2 p1 p2 k3 k4 k5 k6\n";
  }
  if (camera.lens == LensModel::equidistant) {
    return "distortion_model: equidistant\ndistortion_coefficients: " + list(std::span(k).first(4)) +
           "  # k1 k2 k3 k4\n";
  }
  const bool bent_more = k[4] != 0.0;
  return "distortion_model: radial-tangential\ndistortion_coefficients: " +
         list(std::span(k).first(bent_more ? 5 : 4)) + "  # k1 k2 p1 p2" + (bent_more ? " k3\n" : "\n");
}

}  // namespace

std::string camera_file_text(const CameraCalibration& camera, const std::vector<std::string>& remarks) {
  std::string out;
  for (const std::string& remark : remarks) out += "# " + remark + "\n";
  out += "sensor_type: camera\ncamera_model: pinhole\nresolution: [" + std::to_string(camera.width) + ", " +
         std::to_string(camera.height) +
         "]\nintrinsics: " + list(std::array{camera.fx, camera.fy, camera.cx, camera.cy}) +
         "  # fx fy cx cy, pixels\n" + lens_text(camera);
  if (camera.body_from_camera.has_value()) out += mount_text(*camera.body_from_camera);
  return out + sigma_text(camera.sigma);
}

}  // namespace weft
