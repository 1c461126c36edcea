#include "agents/bodies/replay/recording.hpp"

#include <charconv>
#include <opencv2/core.hpp>
#include <sstream>

namespace weft::agents::replay {
namespace {

tl::unexpected<Error> at_line(const std::string& file, int line, const std::string& what) {
  return fail(ErrorCode::invalid, file + ":" + std::to_string(line) + ": " + what);
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  const auto last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

Result<std::vector<double>> numbers(const cv::FileNode& node, const std::string& key, std::size_t fewest,
                                    const std::string& file) {
  if (!node.isSeq() || node.size() < fewest) {
    return fail(ErrorCode::invalid,
                file + ": " + key + ": a list of " + std::to_string(fewest) + " numbers is needed");
  }
  std::vector<double> values;
  for (const cv::FileNode value : node) {
    if (!value.isReal() && !value.isInt()) {
      return fail(ErrorCode::invalid, file + ": " + key + ": holds something that is no number");
    }
    values.push_back(value.real());
  }
  return values;
}

Result<Pose3> pose_from(const std::vector<double>& m, const std::string& file) {
  Eigen::Matrix3d rotation;
  Pose3 pose;
  for (int row = 0; row < 3; ++row) {
    const auto at = static_cast<std::size_t>(row) * 4;
    rotation.row(row) << m[at], m[at + 1], m[at + 2];
    pose.translation[row] = m[at + 3];
  }
  if ((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() > 1e-3 || rotation.determinant() < 0.0) {
    return fail(ErrorCode::invalid, file + ": T_BS: its first three columns are no rotation");
  }
  pose.rotation = Eigen::Quaterniond(rotation).normalized();
  return pose;
}

Result<CameraModel> camera_from(const cv::FileStorage& yaml, const std::string& file) {
  for (const auto& [key, expected] :
       {std::pair{"camera_model", "pinhole"}, {"distortion_model", "radial-tangential"}}) {
    if (const std::string found = yaml[key].isString() ? yaml[key].string() : ""; found != expected) {
      return fail(ErrorCode::invalid, file + ": " + key + ": \"" + found + "\"; only " + expected + " is understood");
    }
  }
  const auto size = numbers(yaml["resolution"], "resolution", 2, file);
  const auto intrinsics = numbers(yaml["intrinsics"], "intrinsics", 4, file);
  const auto distortion = numbers(yaml["distortion_coefficients"], "distortion_coefficients", 4, file);
  const auto mount = numbers(yaml["T_BS"]["data"], "T_BS.data", 16, file);
  for (const auto* list : {&size, &intrinsics, &distortion, &mount}) {
    if (!*list) {
      return fail(list->error());
    }
  }
  auto robot_from_camera = pose_from(*mount, file);
  if (!robot_from_camera) {
    return fail(robot_from_camera.error());
  }
  CameraModel camera;
  camera.width = static_cast<int>((*size)[0]);
  camera.height = static_cast<int>((*size)[1]);
  camera.fx = (*intrinsics)[0];
  camera.fy = (*intrinsics)[1];
  camera.cx = (*intrinsics)[2];
  camera.cy = (*intrinsics)[3];
  for (std::size_t i = 0; i < std::min<std::size_t>(5, distortion->size()); ++i) {
    camera.distortion[i] = (*distortion)[i];
  }
  camera.robot_from_camera = *robot_from_camera;
  return camera;
}

}  // namespace

Result<std::vector<RecordedImage>> parse_image_list(const std::string& text, const std::string& file_name) {
  std::vector<RecordedImage> images;
  std::istringstream rows(text);
  int line = 0;
  for (std::string row; std::getline(rows, row);) {
    ++line;
    row = trimmed(row);
    if (row.empty() || row.front() == '#') {
      continue;
    }
    const auto comma = row.find(',');
    std::int64_t nanoseconds = 0;
    const char* end = row.data() + std::min(comma, row.size());
    const auto [stop, error] = std::from_chars(row.data(), end, nanoseconds);
    if (comma == std::string::npos || error != std::errc() || stop != end || nanoseconds < 0) {
      return at_line(file_name, line, "expected \"nanoseconds,file\", found \"" + row.substr(0, 80) + "\"");
    }
    const std::string file = trimmed(row.substr(comma + 1));
    if (file.empty() || file.find('/') != std::string::npos) {
      return at_line(file_name, line, "the file's name must be that of a file in data/");
    }
    const SensorTime time{Duration(nanoseconds)};
    if (!images.empty() && time <= images.back().time) {
      return at_line(file_name, line, "time does not increase");
    }
    images.push_back({time, file});
  }
  if (images.empty()) {
    return fail(ErrorCode::invalid, file_name + ": lists no image");
  }
  return images;
}

Result<CameraModel> parse_sensor(const std::string& text, const std::string& file_name) {
  try {
    // OpenCV's reader wants the header that EuRoC's files lack.
    const std::string with_header = text.starts_with("%YAML") ? text : "%YAML:1.0\n---\n" + text;
    const cv::FileStorage yaml(with_header, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    return camera_from(yaml, file_name);
  } catch (const cv::Exception& error) {
    return fail(ErrorCode::invalid, file_name + ": no YAML that can be read: " + error.err);
  }
}

}  // namespace weft::agents::replay
