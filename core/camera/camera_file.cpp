#include "core/camera/camera_file.hpp"

#include "core/camera/camera_keys.hpp"
#include "core/camera/camera_parts.hpp"
#include "core/text.hpp"

namespace weft {
namespace {

constexpr std::size_t kLongestFile = 64U << 10U;
constexpr double kFarthest = 100.0;

std::optional<Pose3> read_mount(CameraKeys& keys, const YAML::Node& node, std::string_view key) {
  const std::vector<double> m = read_matrix(keys, node, key, 4, 4, kFarthest);
  Pose3 pose;
  Eigen::Matrix3d rotation;
  for (int row = 0; row < 3; ++row) {
    const auto at = static_cast<std::size_t>(row) * 4;
    rotation.row(row) << m[at], m[at + 1], m[at + 2];
    pose.translation[row] = m[at + 3];
  }
  constexpr double kOff = 1e-3;
  if ((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() > kOff || rotation.determinant() < 0.0)
    keys.wrong(node, std::string(key) + ": its first three columns are no rotation");
  if (m[12] != 0.0 || m[13] != 0.0 || m[14] != 0.0 || m[15] != 1.0)
    keys.wrong(node, std::string(key) + ": its last row must be 0 0 0 1");
  if (!keys.ok()) return std::nullopt;
  pose.rotation = Eigen::Quaterniond(rotation).normalized();
  return pose;
}

CalibrationSigma read_sigma(CameraKeys& keys, const YAML::Node& node) {
  CameraKeys parts(node, keys.file());
  CalibrationSigma sigma;
  std::string known;
  for (const auto& [key, member, most] : kSigmaKeys) {
    if (const std::optional<YAML::Node> value = parts.take(key))
      sigma.*member = parts.number(*value, key, 1e-7, most);
    known += std::string(known.empty() ? "" : ", ") + key;
  }
  if (const std::vector<std::string> rest = parts.left_over(); !rest.empty())
    parts.wrong(node, "weft_sigma has " + known + " only");
  keys.adopt(parts);
  return sigma;
}

void read_pinhole(CameraKeys& keys) {
  const std::optional<YAML::Node> model = keys.need("camera_model");
  if (model.has_value() && !(model->IsScalar() && model->Scalar() == "pinhole"))
    keys.wrong(*model, "camera_model must be pinhole; others (omni, ds, eucm) are not understood");
}

/// Reads the keys that EuRoC's sensor.yaml and a camera of Kalibr's chain share; they differ in one key's name.
CameraCalibration read_euroc(CameraKeys& keys, const char* coefficients_key) {
  CameraCalibration camera;
  read_pinhole(keys);
  if (const std::optional<YAML::Node> size = keys.need("resolution")) {
    if (size->IsSequence() && size->size() == 2) {
      const YAML::Node& list = *size;
      read_size(keys, list[0], list[1], "resolution", camera);
    } else {
      keys.wrong(*size, "resolution must be [width, height]");
    }
  }
  if (const std::optional<YAML::Node> node = keys.need("intrinsics")) {
    const std::vector<double> v = keys.numbers(*node, "intrinsics", 4, 4, -kLongestFocal, kLongestFocal);
    set_intrinsics(keys, *node, "intrinsics", {v[0], v[1], v[2], v[3]}, camera);
  }
  const std::string model = keys.word("distortion_model");
  const bool has_none = model == "none" && !keys.has(coefficients_key);
  if (const auto node = has_none ? std::nullopt : keys.need(coefficients_key); node.has_value() && keys.ok())
    read_lens(keys, model, *node, coefficients_key, camera);
  if (const std::optional<YAML::Node> node = keys.take("T_BS"))
    camera.body_from_camera = read_mount(keys, *node, "T_BS");
  if (const std::optional<YAML::Node> node = keys.take("weft_sigma")) camera.sigma = read_sigma(keys, *node);
  keys.pass_over({"sensor_type", "comment", "rate_hz", "rostopic", "cam_overlaps"});
  return camera;
}

/// Reads one camera of Kalibr's chain. Leaves its T_cam_imu over: that is the pose of an IMU, not of the robot.
Result<CameraFile> read_chain(CameraKeys& keys, const std::string& which) {
  const std::optional<YAML::Node> node = keys.take(which);
  CameraKeys camera_keys(*node, keys.file());
  CameraFile out;
  out.camera = read_euroc(camera_keys, "distortion_coeffs");
  if (const std::optional<YAML::Node> before = camera_keys.take("T_cn_cnm1")) {
    const std::optional<Pose3> camera_from_previous = read_mount(camera_keys, *before, "T_cn_cnm1");
    if (camera_from_previous) out.camera.previous_from_camera = camera_from_previous->inverse();
  }
  keys.adopt(camera_keys);
  if (!keys.ok()) return fail(keys.error());
  out.not_understood = camera_keys.left_over();
  return out;
}

bool is_chain_camera(const std::string& key) {
  return key.size() >= 4 && key.starts_with("cam") && key.find_first_not_of("0123456789", 3) == std::string::npos;
}

Result<CameraFile> read(const YAML::Node& document, std::string_view file, std::string_view which) {
  CameraKeys keys(document, file);
  if (!keys.ok()) return fail(keys.error());
  std::string chain;
  for (const auto& entry : document) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : std::string();
    if (is_chain_camera(key)) chain += (chain.empty() ? "" : ", ") + key;
  }
  if (!chain.empty()) {
    if (keys.has(which) && is_chain_camera(std::string(which))) return read_chain(keys, std::string(which));
    return fail(ErrorCode::invalid,
                std::string(file) + ": has no camera " + std::string(which) + "; it has " + chain);
  }
  CameraFile out;
  if (is_ros(keys)) {
    out.camera = read_ros(keys);
  } else if (keys.has("intrinsics")) {
    out.camera = read_euroc(keys, "distortion_coefficients");
  } else {
    return fail(ErrorCode::invalid,
                std::string(file) +
                    ":1: no camera: neither intrinsics (EuRoC, Kalibr), nor camera_matrix or K (ROS), "
                    "nor cam0 (Kalibr's chain) is there");
  }
  if (!keys.ok()) return fail(keys.error());
  out.not_understood = keys.left_over();
  return out;
}

}  // namespace

Result<CameraFile> parse_camera_file(std::string_view text, std::string_view file, std::string_view camera) try {
  if (text.size() > kLongestFile)
    return fail(ErrorCode::invalid, std::string(file) + ": a camera file has at most 64 KiB");
  std::string yaml(without_byte_order_mark(text));
  if (yaml.starts_with('%')) yaml[0] = '#';  // OpenCV's "%YAML:1.0" is no directive of YAML
  return read(YAML::Load(yaml), file, camera);
} catch (const YAML::Exception& problem) {
  const std::size_t line = problem.mark.is_null() ? 1 : static_cast<std::size_t>(problem.mark.line) + 1;
  return fail(ErrorCode::invalid, std::string(file) + ":" + std::to_string(line) + ": no YAML: " + problem.msg);
}

}  // namespace weft
