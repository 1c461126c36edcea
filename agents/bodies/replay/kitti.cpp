#include "agents/bodies/replay/kitti.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <system_error>

#include "agents/bodies/replay/text_file.hpp"
#include "images/read.hpp"

namespace weft::agents::replay {
namespace {

namespace fs = std::filesystem;

constexpr double kLongestFocalPx = 1e5;

/// Maps the numbers, from 0, that are the images' names to their paths: 000012.png has the time in row 12 (from 0).
using Numbered = std::map<std::size_t, std::string>;

Result<Numbered> images_in(const fs::path& folder) {
  Numbered images;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    const std::string name = entry.path().stem().string();
    std::size_t number = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
    if (read.ec != std::errc{} || read.ptr != name.data() + name.size())
      return fail(ErrorCode::invalid, entry.path().string() + ": expected a number as its name, as in 000012.png");
    images[number] = entry.path().string();
  }
  if (problem) return fail(ErrorCode::unavailable, folder.string() + ": " + problem.message());
  if (images.empty()) return fail(ErrorCode::invalid, folder.string() + ": holds no image");
  return images;
}

Result<std::vector<SensorTime>> parse_times(const std::string& text, const std::string& file) {
  std::vector<SensorTime> times;
  std::istringstream rows(text);
  int line = 0;
  for (std::string row; std::getline(rows, row);) {
    ++line;
    if (row.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::istringstream cell(row);
    double time_s = NAN;
    std::string rest;
    const bool is_number = static_cast<bool>(cell >> time_s) && !(cell >> rest) && time_s >= 0.0 && time_s < 1e9;
    const SensorTime time{from_seconds(is_number ? time_s : 0.0)};
    if (!is_number || (!times.empty() && time <= times.back()))
      return fail(ErrorCode::invalid, file + ":" + std::to_string(line) +
                                          ": expected seconds that increase, found \"" + row.substr(0, 80) + "\"");
    times.push_back(time);
  }
  return times;
}

/// Returns a time for each number up to `last`.
Result<std::vector<SensorTime>> times_of(const fs::path& folder, std::size_t last,
                                         const std::function<void(const std::string&)>& warn) {
  const fs::path file = folder / "times.txt";
  if (fs::exists(file)) {
    const auto text = read_text(file);
    if (!text) return fail(text.error());
    auto times = parse_times(*text, file.string());
    if (!times) return fail(times.error());
    if (times->size() > last) return times;
    return fail(ErrorCode::invalid, file.string() + ": has " + std::to_string(times->size()) +
                                        " times and none for image " + std::to_string(last));
  }
  if (warn) warn(file.string() + ": missing; taken as ten images a second");
  std::vector<SensorTime> times;
  for (std::size_t i = 0; i <= last; ++i) times.push_back(SensorTime{std::chrono::milliseconds(100 * (i + 1))});
  return times;
}

}  // namespace

bool is_kitti(const std::string& folder) {
  return fs::exists(fs::path(folder) / "calib.txt") && fs::is_directory(fs::path(folder) / "image_l");
}

Result<Projection> parse_projection(const std::string& text, const std::string& file, int number) {
  std::istringstream rows(text);
  int line = 0;
  int unnamed = 0;
  for (std::string row; std::getline(rows, row);) {
    ++line;
    const std::size_t colon = row.find(':');
    if (row.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string name = colon == std::string::npos ? "P" + std::to_string(unnamed++) : row.substr(0, colon);
    if (name != "P" + std::to_string(number)) continue;
    std::istringstream cells(colon == std::string::npos ? row : row.substr(colon + 1));
    std::array<double, 12> p{};
    std::string rest;
    for (double& value : p)
      if (!(cells >> value) || !std::isfinite(value)) rest = "short";
    if (!rest.empty() || (cells >> rest))
      return fail(ErrorCode::invalid, file + ":" + std::to_string(line) + ": " + name + " must have 12 numbers");
    const bool is_rectified = p[0] > 0.0 && p[0] < kLongestFocalPx && p[5] == p[0] && p[1] == 0.0 && p[4] == 0.0 &&
                              p[8] == 0.0 && p[9] == 0.0 && p[10] == 1.0;
    if (!is_rectified)
      return fail(ErrorCode::invalid, file + ":" + std::to_string(line) + ": " + name +
                                          " is no projection of a rectified camera (f 0 cx a, 0 f cy b, 0 0 1 c)");
    return Projection{p[0], p[2], p[6], -p[3] / p[0]};
  }
  return fail(ErrorCode::not_found, file + ": has no projection P" + std::to_string(number));
}

Result<KittiCamera> read_kitti(const std::string& folder, const std::string& half,
                               const std::function<void(const std::string&)>& warn) {
  if (half != "image_l" && half != "image_r")
    return fail(ErrorCode::not_found, folder + ": has no camera " + half + "; it has image_l and image_r");
  const fs::path calibration = fs::path(folder) / "calib.txt";
  const auto text = read_text(calibration);
  if (!text) return fail(text.error());
  const auto projection = parse_projection(*text, calibration.string(), half == "image_l" ? 0 : 1);
  if (!projection) return fail(projection.error());
  const fs::path inside = fs::path(folder) / half;
  if (!fs::is_directory(inside)) return fail(ErrorCode::not_found, inside.string() + ": missing");
  const auto files = images_in(inside);
  if (!files) return fail(files.error());
  constexpr std::size_t kMostImages = 1'000'000;
  const std::size_t last = files->rbegin()->first;
  if (last >= kMostImages)
    return fail(ErrorCode::invalid, files->rbegin()->second + ": its number must be below 1000000");
  const auto times = times_of(folder, last, half == "image_l" ? warn : nullptr);
  if (!times) return fail(times.error());
  KittiCamera camera;
  for (const auto& [number, file] : *files) camera.images.push_back({(*times)[number], file});
  const Result<images::Picture> first = images::read(files->begin()->second, images::Shades::grey);
  if (!first) return fail(first.error());
  camera.model.id = fs::path(folder).filename().string() + "/" + half;
  camera.model.width = first->width;
  camera.model.height = first->height;
  camera.model.fx = camera.model.fy = projection->focal_px;
  camera.model.cx = projection->cx;
  camera.model.cy = projection->cy;
  camera.model.robot_from_camera = Pose3{};
  camera.model.robot_from_camera.translation.x() = projection->baseline_m;
  return camera;
}

}  // namespace weft::agents::replay
