#include "agents/bodies/replay/recorded_sensors.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>
#include <utility>

#include "agents/bodies/replay/kitti.hpp"
#include "agents/bodies/replay/recording.hpp"
#include "agents/bodies/replay/text_file.hpp"

namespace weft::agents::replay {
namespace {

namespace fs = std::filesystem;

/// Describes one camera of the recording.
struct RecordedCamera {
  CameraModel model;
  bool has_mount = false;
  std::vector<RecordedImage> images;  ///< with their paths
};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(at, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// Returns mav0/NAME/FILE, or what lies beside mav0 under the camera's name.
fs::path file_of(const fs::path& folder, const std::string& name, const std::string& file) {
  const fs::path within = folder / "mav0" / name / file;
  const fs::path beside = folder / (name + "_" + file);
  return !fs::exists(within) && fs::exists(beside) ? beside : within;
}

/// Returns the images of a folder that has no list, in the order of time: their names are their times.
Result<std::vector<RecordedImage>> images_by_name(const fs::path& folder) {
  std::vector<RecordedImage> images;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    const std::string name = entry.path().stem().string();
    std::int64_t nanoseconds = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), nanoseconds);
    if (read.ec != std::errc{} || read.ptr != name.data() + name.size() || nanoseconds < 0)
      return fail(ErrorCode::invalid, entry.path().string() +
                                          ": without a data.csv its name must be its time in nanoseconds, as in "
                                          "1403636579763555584.png");
    images.push_back({SensorTime{Duration(nanoseconds)}, entry.path().filename().string()});
  }
  if (problem) return fail(ErrorCode::unavailable, folder.string() + ": " + problem.message());
  if (images.empty()) return fail(ErrorCode::invalid, folder.string() + ": holds no image");
  std::ranges::sort(images, {}, &RecordedImage::time);
  const auto twice = std::ranges::adjacent_find(images, {}, &RecordedImage::time);
  if (twice != images.end())
    return fail(ErrorCode::invalid, (folder / twice->file).string() + ": another image has the same time");
  return images;
}

/// Returns what data.csv lists; where there is none, what data/ holds.
Result<std::vector<RecordedImage>> images_of(const WantedSensors& wanted, const std::string& name) {
  const fs::path data = fs::path(wanted.folder) / "mav0" / name / "data";
  const fs::path list = file_of(wanted.folder, name, "data.csv");
  if (!fs::exists(list) && fs::is_directory(data)) {
    if (wanted.warn)
      wanted.warn(list.string() + ": missing; the names of the images in data/ are taken as their times");
    return images_by_name(data);
  }
  const auto text = read_text(list);
  if (!text) return fail(text.error());
  return parse_image_list(*text, list.string());
}

Result<RecordedCamera> read_euroc(const WantedSensors& wanted, const std::string& name) {
  const fs::path folder(wanted.folder);
  RecordedCamera camera;
  auto images = images_of(wanted, name);
  if (!images) return fail(images.error());
  camera.images = std::move(*images);
  for (RecordedImage& image : camera.images) image.file = (folder / "mav0" / name / "data" / image.file).string();
  const fs::path sensor = file_of(folder, name, "sensor.yaml");
  const auto sensor_text = read_text(sensor);
  if (!sensor_text) return fail(sensor_text.error());
  const auto described = parse_camera_file(*sensor_text, sensor.string(), name);
  if (!described) return fail(described.error());
  for (const std::string& part : described->not_understood)
    if (wanted.warn) wanted.warn(part + " is not understood and not used");
  camera.has_mount = described->camera.body_from_camera.has_value();
  camera.model = camera_model_from(described->camera, folder.filename().string() + "/" + name, {});
  return camera;
}

Result<RecordedCamera> read_camera(const WantedSensors& wanted, const std::string& name) {
  if (!is_kitti(wanted.folder)) return read_euroc(wanted, name);
  Result<KittiCamera> half = read_kitti(wanted.folder, name, wanted.warn);
  if (!half) return fail(half.error());
  return RecordedCamera{std::move(half->model), false, std::move(half->images)};
}

std::vector<Shot> shots_of(const std::vector<RecordedImage>& left) {
  std::vector<Shot> shots;
  for (const RecordedImage& image : left) shots.push_back({image.time, image.file, {}});
  return shots;
}

/// Joins rows whose times agree; a row without its other half is a shot with an empty path.
std::vector<Shot> paired(const std::vector<RecordedImage>& left, const std::vector<RecordedImage>& right) {
  constexpr Duration together = std::chrono::milliseconds(1);
  std::vector<Shot> shots;
  std::size_t l = 0;
  std::size_t r = 0;
  while (l < left.size() || r < right.size()) {
    const bool has_left = l < left.size() && (r == right.size() || left[l].time <= right[r].time + together);
    const bool has_right = r < right.size() && (l == left.size() || right[r].time <= left[l].time + together);
    Shot shot;
    shot.time = has_left ? left[l].time : right[r].time;
    if (has_left) shot.left = left[l++].file;
    if (has_right) shot.right = right[r++].file;
    shots.push_back(std::move(shot));
  }
  return shots;
}

Result<RecordedSensor> read_sensor(const WantedSensors& wanted, const std::string& name) {
  const std::vector<std::string> cameras = split(name, '+');
  if (cameras.size() > 2)
    return fail(ErrorCode::invalid, "sensor " + name + ": a stereo pair is of two cameras, LEFT+RIGHT");
  Result<RecordedCamera> left = read_camera(wanted, cameras[0]);
  if (!left) return fail(left.error());
  if (!left->has_mount && !wanted.robot_from_camera) {
    return fail(ErrorCode::invalid, wanted.folder + ": how camera " + cameras[0] +
                                        " is mounted (T_BS of its sensor.yaml) is missing; add it, or give a camera "
                                        "file that has it");
  }
  RecordedSensor sensor{{name, SensorKind::camera, left->model}, {}};
  if (cameras.size() == 1) {
    sensor.shots = shots_of(left->images);
    return sensor;
  }
  Result<RecordedCamera> right = read_camera(wanted, cameras[1]);
  if (!right) return fail(right.error());
  sensor.sensor.kind = SensorKind::stereo;
  sensor.sensor.right = right->model;
  sensor.shots = paired(left->images, right->images);
  return sensor;
}

/// Moves the whole rig so that the first camera is mounted as told.
void mount(std::vector<RecordedSensor>& sensors, const Pose3& robot_from_first) {
  const Pose3 told_from_recorded = robot_from_first * sensors.front().sensor.camera.robot_from_camera.inverse();
  for (RecordedSensor& one : sensors) {
    one.sensor.camera.robot_from_camera = told_from_recorded * one.sensor.camera.robot_from_camera;
    if (one.sensor.right)
      one.sensor.right->robot_from_camera = told_from_recorded * one.sensor.right->robot_from_camera;
  }
  sensors.front().sensor.camera.robot_from_camera = robot_from_first;
}

}  // namespace

Result<std::vector<RecordedSensor>> read_sensors(const WantedSensors& wanted) {
  std::vector<RecordedSensor> sensors;
  for (const std::string& name : split(wanted.names, ',')) {
    if (name.empty()) return fail(ErrorCode::invalid, "sensors \"" + wanted.names + "\": a name is empty");
    Result<RecordedSensor> sensor = read_sensor(wanted, name);
    if (!sensor) return fail(sensor.error());
    sensors.push_back(std::move(*sensor));
  }
  if (wanted.robot_from_camera) mount(sensors, *wanted.robot_from_camera);
  return sensors;
}

}  // namespace weft::agents::replay
