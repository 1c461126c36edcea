#include "core/camera/camera_parts.hpp"

#include <cmath>

namespace weft {

void read_size(CameraKeys& keys, const YAML::Node& width, const YAML::Node& height, std::string_view key,
               CameraCalibration& camera) {
  constexpr double kWidest = 16384.0;
  const double w = keys.number(width, key, 1.0, kWidest);
  const double h = keys.number(height, key, 1.0, kWidest);
  if (w != std::floor(w) || h != std::floor(h)) keys.wrong(width, std::string(key) + " must be whole pixels");
  camera.width = static_cast<int>(w);
  camera.height = static_cast<int>(h);
}

void set_intrinsics(CameraKeys& keys, const YAML::Node& node, std::string_view key,
                    const std::array<double, 4>& values, CameraCalibration& camera) {
  const auto [fx, fy, cx, cy] = values;
  if (fx <= 0.0 || fy <= 0.0 || fx > kLongestFocal || fy > kLongestFocal)
    keys.wrong(node, std::string(key) + ": focal lengths must be in (0, 100000] pixels");
  if (cx < 0.0 || cy < 0.0 || cx > camera.width || cy > camera.height)
    keys.wrong(node, std::string(key) + ": the optical centre lies outside the image");
  camera.fx = fx;
  camera.fy = fy;
  camera.cx = cx;
  camera.cy = cy;
}

std::vector<double> read_matrix(CameraKeys& keys, const YAML::Node& node, std::string_view key, std::size_t rows,
                                std::size_t columns, double most) {
  const std::string name(key);
  const std::size_t size = rows * columns;
  if (node.IsSequence()) {  // rows, as Kalibr writes them
    std::vector<double> values;
    for (const YAML::Node& row : node) {
      const std::vector<double> cells = keys.numbers(row, key, columns, columns, -most, most);
      values.insert(values.end(), cells.begin(), cells.end());
    }
    if (node.size() != rows) keys.wrong(node, name + " must have " + std::to_string(rows) + " rows");
    values.resize(size, 0.0);
    return values;
  }
  CameraKeys parts(node, keys.file());
  const std::optional<YAML::Node> data = parts.need("data");
  std::vector<double> values(size, 0.0);
  if (data.has_value()) values = parts.numbers(*data, name + ".data", size, size, -most, most);
  for (const auto& [side, expected] : {std::pair{"rows", rows}, {"cols", columns}}) {
    if (const std::optional<YAML::Node> stated = parts.take(side)) {
      const auto wanted = static_cast<double>(expected);
      parts.number(*stated, name + "." + side, wanted, wanted);
    }
  }
  keys.adopt(parts);
  return values;
}

}  // namespace weft
