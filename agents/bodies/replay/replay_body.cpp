#include "agents/bodies/replay/replay_body.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "agents/bodies/replay/recorded_sensors.hpp"
#include "agents/bodies/replay/recording.hpp"
#include "agents/bodies/replay/text_file.hpp"
#include "images/read.hpp"

namespace weft::agents::replay {
namespace {

namespace fs = std::filesystem;

class ReplayBody final : public Body {
 public:
  ReplayBody(const ReplayBodyConfig& config, std::vector<RecordedSensor> sensors, std::vector<RecordedWheels> wheels)
      : config_(config), sensors_(std::move(sensors)), wheels_(std::move(wheels)), next_(sensors_.size(), 0) {}

  Result<Sample> step(const Twist& command) override;
  Result<void> drive_by_hand(const std::vector<SitePoint>& along) override;
  void stop_hand() override {}
  Rig rig() const override {
    Rig rig;
    for (const RecordedSensor& one : sensors_) rig.sensors.push_back(one.sensor);
    return rig;
  }
  std::string kind() const override { return "replay"; }

 private:
  /// Returns the time of the next image; none: the recording is over.
  std::optional<SensorTime> next_time() const;
  Error over() const;
  /// Returns what the sensor saw then; none, with a warning: a file is missing, damaged or of another size.
  std::optional<View> look(const Sensor& sensor, const Shot& shot) const;
  std::optional<Image> read(const std::string& path, const CameraModel& camera) const;

  ReplayBodyConfig config_;
  std::vector<RecordedSensor> sensors_;
  std::vector<RecordedWheels> wheels_;
  std::vector<std::size_t> next_;  // shot of each sensor
  std::optional<SensorTime> last_;
  std::uint64_t frame_ = 0;
  std::size_t dropped_ = 0;
};

std::optional<Image> ReplayBody::read(const std::string& path, const CameraModel& camera) const {
  Result<images::Picture> grey = images::read(path, images::Shades::grey);
  if (grey && (grey->width != camera.width || grey->height != camera.height)) {
    grey = fail(ErrorCode::invalid, path + ": is " + std::to_string(grey->width) + " x " +
                                        std::to_string(grey->height) + " pixels, its calibration says " +
                                        std::to_string(camera.width) + " x " + std::to_string(camera.height));
  }
  if (!grey) {
    if (config_.warn) config_.warn(grey.error().message + "; the frame is dropped");
    return std::nullopt;
  }
  return Image{grey->width, grey->height, std::make_shared<Bytes>(std::move(grey->samples))};
}

std::optional<View> ReplayBody::look(const Sensor& sensor, const Shot& shot) const {
  View view;
  view.frame = frame_;
  view.time = shot.time;
  view.sensor = sensor.id;
  view.calibration = sensor.camera.id;
  if (sensor.kind == SensorKind::camera) {
    std::optional<Image> image = read(shot.left, sensor.camera);
    if (!image) return std::nullopt;
    view.data = std::move(*image);
    return view;
  }
  if (shot.left.empty() || shot.right.empty()) {
    if (config_.warn)
      config_.warn(shot.left + shot.right + ": its other half of " + sensor.id +
                   " was not recorded within a millisecond; the pair is dropped");
    return std::nullopt;
  }
  std::optional<Image> left = read(shot.left, sensor.camera);
  std::optional<Image> right = read(shot.right, *sensor.right);
  if (!left || !right) return std::nullopt;
  view.data = StereoPair{std::move(*left), std::move(*right)};
  return view;
}

std::optional<SensorTime> ReplayBody::next_time() const {
  std::optional<SensorTime> next;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    if (next_[i] == sensors_[i].shots.size()) continue;
    const SensorTime time = sensors_[i].shots[next_[i]].time;
    if (!next || time < *next) next = time;
  }
  return next;
}

Error ReplayBody::over() const {
  std::size_t images = 0;
  for (const RecordedSensor& one : sensors_) images += one.shots.size();
  const std::string over = config_.folder + ": recording is over after " + std::to_string(images) + " images";
  if (dropped_ == 0) return {ErrorCode::unavailable, over};
  return {ErrorCode::corrupt, over + ", " + std::to_string(dropped_) +
                                  " of them dropped as they could not be read or had the wrong size"};
}

Result<Sample> ReplayBody::step(const Twist& /*command*/) {
  constexpr Duration together = std::chrono::milliseconds(1);
  const std::optional<SensorTime> now = next_time();
  if (!now) return tl::unexpected(over());
  Sample sample;
  sample.time = *now;
  sample.frame = ++frame_;
  sample.motion.elapsed = last_ ? *now - *last_ : Duration{};
  if (last_) sample.motion.wheels = wheels_between(wheels_, *last_, *now);
  last_ = now;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const std::vector<Shot>& shots = sensors_[i].shots;
    if (next_[i] == shots.size() || shots[next_[i]].time > *now + together) continue;
    if (std::optional<View> view = look(sensors_[i].sensor, shots[next_[i]++])) {
      sample.views.push_back(std::move(*view));
    } else {
      ++dropped_;
    }
  }
  return sample;
}

Result<void> ReplayBody::drive_by_hand(const std::vector<SitePoint>& /*along*/) {
  return fail(ErrorCode::refused, "a recording cannot be driven; only simulated robots follow a line");
}

}  // namespace

Result<std::unique_ptr<Body>> make_replay_body(const ReplayBodyConfig& config) {
  Result<std::vector<RecordedSensor>> sensors =
      read_sensors({config.folder, config.camera, config.robot_from_camera, config.warn});
  if (!sensors) return fail(sensors.error());
  std::vector<RecordedWheels> wheels;
  if (const fs::path file = fs::path(config.folder) / "mav0" / "wheels0" / "data.csv"; fs::exists(file)) {
    const auto text = read_text(file);
    if (!text) return fail(text.error());
    auto rows = parse_wheels(*text, file.string());
    if (!rows) return fail(rows.error());
    wheels = std::move(*rows);
  }
  return std::unique_ptr<Body>(std::make_unique<ReplayBody>(config, std::move(*sensors), std::move(wheels)));
}

}  // namespace weft::agents::replay
