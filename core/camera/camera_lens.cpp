#include <algorithm>

#include "core/camera/camera_parts.hpp"
#include "core/camera/lens_check.hpp"

namespace weft {
namespace {

constexpr std::size_t kOfRadtan = 5;
constexpr std::size_t kOfEquidistant = 4;
constexpr std::size_t kOfRational = 8;
constexpr std::size_t kLongestList = 14;  // OpenCV's, with thin prisms and a tilted sensor

/// Gives the camera its lens model and returns how many coefficients the model has; 0: its name is unknown.
std::size_t begin_lens(const std::string& model, CameraCalibration& camera) {
  if (model == "radial-tangential" || model == "radtan" || model == "plumb_bob") return kOfRadtan;
  if (model == "equidistant" || model == "fisheye") {
    camera.lens = LensModel::equidistant;
    return kOfEquidistant;
  }
  if (model != "rational_polynomial") return 0;
  camera.lens = LensModel::rational;
  return kOfRational;
}

/// Takes zeros for coefficients that the model does not have: ROS's lists are as long as their writer likes.
void check_count(CameraKeys& keys, const std::string& model, const YAML::Node& node, std::string_view key,
                 const std::vector<double>& values, std::size_t most) {
  const std::string name(key);
  if (!values.empty() && values.size() < 4) {
    keys.wrong(node, name + " must be a list of 4 to " + std::to_string(most) + " numbers, or an empty one");
  }
  for (std::size_t i = most; i < values.size(); ++i) {
    if (values[i] == 0.0) continue;
    keys.wrong(node, name + ": the number at place " + std::to_string(i + 1) + " must be 0, since " + model +
                         " has " + std::to_string(most) + " coefficients; rational_polynomial has 8");
  }
}

void set_coefficients(const std::vector<double>& values, CameraCalibration& camera) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i < camera.distortion.size()) {
      camera.distortion[i] = values[i];
    } else if (camera.lens == LensModel::rational && i < kOfRational) {
      camera.divisor[i - camera.distortion.size()] = values[i];
    }
  }
  const auto is_zero = [](double k) { return k == 0.0; };
  if (camera.lens == LensModel::rational && std::all_of(camera.divisor.begin(), camera.divisor.end(), is_zero)) {
    camera.lens = LensModel::radtan;
  }
}

}  // namespace

void read_lens(CameraKeys& keys, const std::string& model, const YAML::Node& coefficients, std::string_view key,
               CameraCalibration& camera) {
  if (model == "none") return;
  const std::size_t most = begin_lens(model, camera);
  if (most == 0) {
    keys.wrong(coefficients,
               "distortion_model '" + model.substr(0, 40) +
                   "' is unknown here; radtan (radial-tangential, plumb_bob), equidistant (fisheye) and "
                   "rational_polynomial are understood");
    return;
  }
  std::vector<double> values;
  if (!coefficients.IsNull()) values = keys.numbers(coefficients, key, 0, kLongestList, -1e6, 1e6);
  check_count(keys, model, coefficients, key, values, most);
  set_coefficients(values, camera);
  if (!keys.ok()) return;
  if (const Result<void> sound = check_lens(camera); !sound)
    keys.wrong(coefficients, std::string(key) + ": " + sound.error().message);
}

}  // namespace weft
