#include "clients/evaluate/ceiling/frames/recording.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "agents/perception/lens.hpp"
#include "clients/evaluate/files.hpp"
#include "core/config/config.hpp"
#include "storage/formats/gzip.hpp"

namespace weft::evaluate::ceiling {
namespace {

namespace fs = std::filesystem;

/// Returns the only file of a folder whose name begins and ends so.
Result<fs::path> only_file(const fs::path& folder, const std::string& begins, const std::string& ends) {
  std::vector<fs::path> found;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begins) && name.ends_with(ends)) found.push_back(entry.path());
  }
  const std::string what = folder.string() + ": ";
  if (problem) return fail(ErrorCode::not_found, what + "no folder that can be read (" + problem.message() + ")");
  if (found.empty()) return fail(ErrorCode::not_found, what + "holds no file " + begins + "*" + ends);
  if (found.size() > 1)
    return fail(ErrorCode::invalid, what + "holds " + std::to_string(found.size()) + " files " + begins + "*" + ends +
                                        "; a recording has one: put each in a folder of its own");
  return found.front();
}

/// Reads lens and ceiling.
Result<Recording> read_setup(const fs::path& file) {
  const Result<std::string> text = read_text(file, "description of the lens and the ceiling");
  if (!text) return fail(text.error());
  const config::Table table = config::parse(*text, file.string());
  Recording recording;
  agents::CameraModel& camera = recording.camera;
  camera.id = "recorded";
  camera.width = static_cast<int>(table.integer("width", config::required, 64, 8192));
  camera.height = static_cast<int>(table.integer("height", config::required, 64, 8192));
  camera.fx = table.number("fx", config::required, 1.0, 1e5);
  camera.fy = table.number("fy", config::required, 1.0, 1e5);
  camera.cx = table.number("cx", config::required, 0.0, 8192.0);
  camera.cy = table.number("cy", config::required, 0.0, 8192.0);
  camera.lens = LensModel::equidistant;
  const char* const terms[] = {"k1", "k2", "k3", "k4"};
  for (std::size_t i = 0; i < 4; ++i) camera.distortion[i] = table.number(terms[i], 0.0, -10.0, 10.0);
  recording.away_m = table.number("ceiling_height_m", config::required, 1.0, 39.0);
  static_cast<void>(table.numbers("light_grid_m", std::vector<double>{}, 0, 2, 0.01, 100.0));
  if (const Result<void> good = table.result(); !good) return fail(good.error());
  camera = straight_up(camera);
  if (const Result<void> sound = agents::check(camera); !sound)
    return fail(sound.error().code, file.string() + ": " + sound.error().message);
  return recording;
}

Result<void> read_frames(const fs::path& file, Recording& recording) {
  const Result<std::string> packed = read_text(file, "recorded frames");
  if (!packed) return fail(packed.error());
  const auto pixels =
      static_cast<std::size_t>(recording.camera.width) * static_cast<std::size_t>(recording.camera.height);
  const ByteView bytes(reinterpret_cast<const std::uint8_t*>(packed->data()), packed->size());
  const Result<Bytes> raw = formats::gunzip(bytes, kMostFrames * pixels);
  if (!raw && raw.error().code == ErrorCode::exhausted)
    return fail(ErrorCode::exhausted,
                file.string() + ": holds more than " + std::to_string(kMostFrames) + " frames; cut it");
  if (!raw) return fail(raw.error().code, file.string() + ": " + raw.error().message);
  const std::string size = std::to_string(recording.camera.width) + "x" + std::to_string(recording.camera.height);
  if (raw->size() < 2 * pixels || raw->size() % pixels != 0)
    return fail(ErrorCode::corrupt, file.string() + ": expands to " + std::to_string(raw->size()) +
                                        " bytes, not to two or more frames of " + size + " bytes (width and height " +
                                        "in ceiling.toml)");
  for (std::size_t from = 0; from < raw->size(); from += pixels) {
    const auto first = raw->begin() + static_cast<std::ptrdiff_t>(from);
    recording.frames.push_back({recording.camera.width, recording.camera.height,
                                std::make_shared<const Bytes>(first, first + static_cast<std::ptrdiff_t>(pixels))});
  }
  return {};
}

Result<void> read_golden(const fs::path& file, Recording& recording) {
  const Result<std::string> text = read_text(file, "rows of another tracker");
  if (!text) return fail(text.error());
  std::istringstream lines(*text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream row(line);
    double u = 0.0;
    double v = 0.0;
    double theta = 0.0;
    std::string more;
    const bool is_row = static_cast<bool>(row >> u >> v >> theta) && !(row >> more);
    if (!is_row || !std::isfinite(u) || !std::isfinite(v) || !std::isfinite(theta))
      return fail(ErrorCode::invalid,
                  file.string() + ":" + std::to_string(number) + ": is not 'u v theta', three finite numbers");
    // theta turns the ceiling against the camera: the camera's own heading is the other way round.
    recording.golden_from_camera.push_back({u * recording.away_m, v * recording.away_m, wrap_angle(-theta)});
  }
  if (number == recording.frames.size()) return {};
  return fail(ErrorCode::invalid, file.string() + ": has " + std::to_string(number) + " rows for " +
                                      std::to_string(recording.frames.size()) + " frames; one a frame is wanted");
}

}  // namespace

agents::CameraModel straight_up(agents::CameraModel camera) {
  camera.robot_from_camera = agents::downward_mount(0.0, 0.0, kRecordedMountM, -std::numbers::pi / 2, 0.0, 0.0);
  return camera;
}

Result<Recording> read_recording(const fs::path& folder) {
  const Result<fs::path> frames = only_file(folder, "frames_", ".raw.gz");
  if (!frames) return fail(frames.error());
  const Result<fs::path> golden = only_file(folder, "golden_", ".txt");
  if (!golden) return fail(golden.error());
  Result<Recording> recording = read_setup(folder / "ceiling.toml");
  if (!recording) return recording;
  if (const Result<void> read = read_frames(*frames, *recording); !read) return fail(read.error());
  if (const Result<void> read = read_golden(*golden, *recording); !read) return fail(read.error());
  return recording;
}

}  // namespace weft::evaluate::ceiling
