#include "agents/agent/process/recorded_body.hpp"

#include "agents/agent/process/options.hpp"
#include "agents/agent/process/read_camera_file.hpp"
#include "agents/bodies/replay/replay_body.hpp"

namespace weft::agents {

Result<std::unique_ptr<Body>> make_recorded_body(const Options& options, const Warn& warn) {
  replay::ReplayBodyConfig config;
  config.folder = options.recording;
  config.camera = options.camera;
  config.warn = warn;
  if (options.calibration.has_value()) {
    const std::string first = options.camera.substr(0, options.camera.find_first_of("+,"));
    const Result<CameraFile> file = read_camera_file(*options.calibration, first);
    if (!file) return fail(file.error());
    config.robot_from_camera = file->camera.body_from_camera;
  }
  if (options.mount.has_value()) config.robot_from_camera = options.mount;
  return replay::make_replay_body(config);
}

}  // namespace weft::agents
