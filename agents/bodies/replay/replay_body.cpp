#include "agents/bodies/replay/replay_body.hpp"

#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "agents/bodies/replay/recording.hpp"

namespace weft::agents::replay {
namespace {

namespace fs = std::filesystem;

class ReplayBody final : public Body {
 public:
  ReplayBody(const ReplayBodyConfig& config, fs::path images_dir, std::vector<RecordedImage> images,
             std::vector<RecordedWheels> wheels, CameraModel camera)
      : config_(config),
        images_dir_(std::move(images_dir)),
        images_(std::move(images)),
        wheels_(std::move(wheels)),
        camera_(std::move(camera)) {}

  Result<Sample> step(const Twist& command) override;
  Result<void> drive_by_hand(const std::vector<SitePoint>& along) override;
  void stop_hand() override {}
  Rig rig() const override { return {{{config_.camera, SensorKind::camera, camera_}}}; }
  std::string kind() const override { return "replay"; }

 private:
  /// Nothing when the file is missing, damaged or of another size.
  std::optional<Image> read(const fs::path& path) const;

  ReplayBodyConfig config_;
  fs::path images_dir_;
  std::vector<RecordedImage> images_;
  std::vector<RecordedWheels> wheels_;
  CameraModel camera_;
  std::size_t next_ = 0;
  std::size_t dropped_ = 0;
};

std::optional<Image> ReplayBody::read(const fs::path& path) const {
  cv::Mat grey;
  std::string reason = "missing or damaged";
  try {
    grey = cv::imread(path.string(), cv::IMREAD_GRAYSCALE);
  } catch (const cv::Exception& error) {
    reason = error.err;
  }
  if (!grey.empty() && (grey.cols != camera_.width || grey.rows != camera_.height)) {
    reason = "is " + std::to_string(grey.cols) + " x " + std::to_string(grey.rows) + " pixels, sensor.yaml says " +
             std::to_string(camera_.width) + " x " + std::to_string(camera_.height);
    grey.release();
  }
  if (grey.empty()) {
    if (config_.warn) {
      config_.warn(path.string() + ": " + reason + "; the frame is dropped");
    }
    return std::nullopt;
  }
  auto pixels = std::make_shared<Bytes>();
  pixels->assign(grey.datastart, grey.dataend);
  return Image{grey.cols, grey.rows, std::move(pixels)};
}

Result<Sample> ReplayBody::step(const Twist& /*command*/) {
  if (next_ == images_.size()) {
    const std::string over =
        config_.folder + ": recording is over after " + std::to_string(images_.size()) + " images";
    if (dropped_ == 0) return fail(ErrorCode::unavailable, over);
    return fail(ErrorCode::corrupt, over + ", " + std::to_string(dropped_) +
                                        " of them dropped as they could not be read or had the wrong size");
  }
  const RecordedImage& recorded = images_[next_];
  Sample sample;
  sample.time = recorded.time;
  sample.motion.elapsed = next_ == 0 ? Duration{} : recorded.time - images_[next_ - 1].time;
  if (next_ > 0) sample.motion.wheels = wheels_between(wheels_, images_[next_ - 1].time, recorded.time);
  sample.frame = ++next_;
  if (auto image = read(images_dir_ / recorded.file)) {
    View view;
    view.frame = sample.frame;
    view.time = sample.time;
    view.sensor = config_.camera;
    view.calibration = camera_.id;
    view.data = std::move(*image);
    sample.views.push_back(std::move(view));
  } else {
    ++dropped_;
  }
  return sample;
}

Result<void> ReplayBody::drive_by_hand(const std::vector<SitePoint>& /*along*/) {
  return fail(ErrorCode::refused, "a recording cannot be driven; only simulated robots follow a line");
}

Result<std::string> read_text(const fs::path& path) {
  const std::ifstream file(path, std::ios::binary);
  if (!file) {
    return fail(ErrorCode::not_found,
                path.string() + ": missing; a recording has mav0/CAMERA/data.csv, sensor.yaml and data/");
  }
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

Result<std::unique_ptr<Body>> make_replay_body(const ReplayBodyConfig& config) {
  const fs::path folder = fs::path(config.folder) / "mav0" / config.camera;
  const fs::path list = folder / "data.csv";
  const fs::path sensor = folder / "sensor.yaml";
  const auto list_text = read_text(list);
  if (!list_text) {
    return fail(list_text.error());
  }
  auto images = parse_image_list(*list_text, list.string());
  if (!images) {
    return fail(images.error());
  }
  std::vector<RecordedWheels> wheels;
  if (const fs::path file = fs::path(config.folder) / "mav0" / "wheels0" / "data.csv"; fs::exists(file)) {
    const auto text = read_text(file);
    if (!text) return fail(text.error());
    auto rows = parse_wheels(*text, file.string());
    if (!rows) return fail(rows.error());
    wheels = std::move(*rows);
  }
  const auto sensor_text = read_text(sensor);
  if (!sensor_text) {
    return fail(sensor_text.error());
  }
  const auto described = parse_camera_file(*sensor_text, sensor.string(), config.camera);
  if (!described) {
    return fail(described.error());
  }
  if (config.warn) {
    for (const std::string& part : described->not_understood) config.warn(part + " is not understood and not used");
  }
  CameraModel camera =
      camera_model_from(described->camera, fs::path(config.folder).filename().string() + "/" + config.camera, {});
  if (config.robot_from_camera) {
    camera.robot_from_camera = *config.robot_from_camera;
  } else if (!described->camera.body_from_camera) {
    return fail(ErrorCode::invalid, sensor.string() +
                                        ": T_BS, how the camera is mounted, is missing; add it, or give "
                                        "a camera file that has it");
  }
  return std::unique_ptr<Body>(std::make_unique<ReplayBody>(config, folder / "data", std::move(*images),
                                                            std::move(wheels), std::move(camera)));
}

}  // namespace weft::agents::replay
