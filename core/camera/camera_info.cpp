#include <algorithm>

#include "core/camera/camera_parts.hpp"

namespace weft {
namespace {

using Names = std::initializer_list<const char*>;

/// Takes the first of these keys that is there, with its value: a message names some things otherwise than a file.
std::pair<std::string, std::optional<YAML::Node>> take_one(CameraKeys& keys, Names names) {
  for (const char* const name : names) {
    if (keys.has(name)) return {name, keys.take(name)};
  }
  return {*names.begin(), keys.need(*names.begin())};
}

void read_camera_matrix(CameraKeys& keys, CameraCalibration& camera) {
  const auto [key, node] = take_one(keys, {"camera_matrix", "K", "k"});
  if (!node.has_value()) return;
  constexpr std::size_t kSize = 9;
  const std::vector<double> k = node->IsSequence()
                                    ? keys.numbers(*node, key, kSize, kSize, -kLongestFocal, kLongestFocal)
                                    : read_matrix(keys, *node, key, 3, 3, kLongestFocal);
  if (k[1] != 0.0 || k[3] != 0.0 || k[6] != 0.0 || k[7] != 0.0 || k[8] != 1.0)
    keys.wrong(*node, key + " must be fx 0 cx, 0 fy cy, 0 0 1");
  set_intrinsics(keys, *node, key, {k[0], k[4], k[2], k[5]}, camera);
}

/// Returns the model. Empty: a driver leaves the name so for a camera never calibrated, and gives no coefficients.
std::string model_of(CameraKeys& keys) {
  const std::optional<YAML::Node> node = keys.need("distortion_model");
  if (!node.has_value() || node->IsNull()) return {};
  if (!node->IsScalar()) keys.wrong(*node, "distortion_model must be a word");
  return node->IsScalar() ? node->Scalar() : std::string();
}

void read_named_lens(CameraKeys& keys, const std::string& model, const YAML::Node& coefficients,
                     const std::string& key, CameraCalibration& camera) {
  const bool has_none = coefficients.IsNull() || (coefficients.IsSequence() && coefficients.size() == 0);
  if (!(model.empty() && has_none)) read_lens(keys, model, coefficients, key, camera);
}

void read_coefficients(CameraKeys& keys, CameraCalibration& camera) {
  const std::string model = model_of(keys);
  const auto [key, node] = take_one(keys, {"distortion_coefficients", "D", "d"});
  if (!node.has_value() || !keys.ok()) return;
  if (!node->IsMap()) return read_named_lens(keys, model, *node, key, camera);
  CameraKeys parts(*node, keys.file());
  if (const std::optional<YAML::Node> data = parts.need("data"))
    read_named_lens(parts, model, *data, key + ".data", camera);
  keys.adopt(parts);
}

/// Refuses pixels that were joined: the file describes larger images than those that come.
void refuse_binning(CameraKeys& keys) {
  for (const char* const key : {"binning_x", "binning_y"}) {
    const std::optional<YAML::Node> node = keys.take(key);
    if (!node.has_value()) continue;
    const double binning = keys.number(*node, key, 0.0, 1e6);
    if (binning > 1.0)
      keys.wrong(*node,
                 std::string(key) +
                     " must be 0 or 1: images with joined pixels are not understood; calibrate with the images "
                     "as they come");
  }
}

/// Refuses a part of the image, for the same reason. All zeros are the whole of it, as in ROS.
void refuse_part(CameraKeys& keys, const CameraCalibration& camera) {
  const std::optional<YAML::Node> node = keys.take("roi");
  if (!node.has_value() || node->IsNull()) return;
  CameraKeys parts(*node, keys.file());
  bool is_whole = true;
  for (const auto& [key, whole] :
       {std::pair{"x_offset", 0}, {"y_offset", 0}, {"width", camera.width}, {"height", camera.height}}) {
    const std::optional<YAML::Node> value = parts.take(key);
    const double number = value.has_value() ? parts.number(*value, std::string("roi.") + key, 0.0, 1e6) : 0.0;
    is_whole = is_whole && (number == 0.0 || number == whole);
  }
  keys.adopt(parts);
  if (!is_whole)
    keys.wrong(*node,
               "roi must be the whole image, or all 0: parts of it are not understood; calibrate with the images as "
               "they come");
}

}  // namespace

bool is_ros(const CameraKeys& keys) {
  return keys.has("camera_matrix") || keys.has("K") || keys.has("k");
}

CameraCalibration read_ros(CameraKeys& keys) {
  CameraCalibration camera;
  const auto [width_key, width] = take_one(keys, {"image_width", "width"});
  const auto [height_key, height] = take_one(keys, {"image_height", "height"});
  if (width.has_value() && height.has_value()) {
    read_size(keys, *width, *height, width_key + ", " + height_key, camera);
  }
  read_camera_matrix(keys, camera);
  read_coefficients(keys, camera);
  refuse_binning(keys);
  refuse_part(keys, camera);
  // These serve who takes rectified images; views here are not.
  keys.pass_over({"camera_name", "header", "rectification_matrix", "projection_matrix", "R", "r", "P", "p"});
  return camera;
}

}  // namespace weft
