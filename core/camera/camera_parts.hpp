#pragma once
// Private to core/camera: what cameras' files have in common, whoever writes them.
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/camera/camera_file.hpp"
#include "core/camera/camera_keys.hpp"

namespace weft {

inline constexpr double kLongestFocal = 1e5;

/// Takes whole pixels, 1 .. 16384.
void read_size(CameraKeys& keys, const YAML::Node& width, const YAML::Node& height, std::string_view key,
               CameraCalibration& camera);

/// Takes fx, fy, cx, cy: focal lengths in (0, 100000] pixels, the centre within the image, whose size is known.
void set_intrinsics(CameraKeys& keys, const YAML::Node& node, std::string_view key,
                    const std::array<double, 4>& values, CameraCalibration& camera);

/// Takes a lens by its name, as EuRoC, Kalibr, ROS and ROS 2 write it, and its coefficients: a list of numbers or
/// nothing. Refuses a lens that is not monotone over the image, whose size and intrinsics are known.
void read_lens(CameraKeys& keys, const std::string& model, const YAML::Node& coefficients, std::string_view key,
               CameraCalibration& camera);

/// Takes a matrix, row by row: with rows, cols and data, as EuRoC and ROS write it, or as a list of rows (Kalibr).
std::vector<double> read_matrix(CameraKeys& keys, const YAML::Node& node, std::string_view key, std::size_t rows,
                                std::size_t columns, double most);

/// Tell whether a document is a sensor_msgs/CameraInfo, and read it: as ROS's camera_calibration writes it
/// (camera_matrix), or as a message is printed (K or k).
bool is_ros(const CameraKeys& keys);
CameraCalibration read_ros(CameraKeys& keys);

}  // namespace weft
