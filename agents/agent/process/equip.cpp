#include "agents/agent/process/equip.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>
#include <variant>

#include "agents/bodies/replay/replay_body.hpp"
#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/bearing/bearing.hpp"
#include "agents/methods/floor/floor.hpp"
#include "agents/navigation/config.hpp"
#include "agents/navigation/navigator_of.hpp"

namespace weft::agents {
namespace {

/// Every method that an agent can run; chosen here and nowhere else.
using AnyMethod = std::variant<Floor, Bearing>;

template <class M, class Config>
Result<AnyMethod> made(const Config& config, const CameraModel& camera) {
  Result<M> method = M::make(config, camera);
  if (!method) return fail(method.error());
  return AnyMethod(std::move(*method));
}

Result<AnyMethod> make_method(const Options& options, const CameraModel& camera) {
  if (options.method == Bearing::name) return made<Bearing>(options.bearing, camera);
  return made<Floor>(options.floor, camera);
}

Result<std::unique_ptr<Body>> make_sim(const Options& options, const std::function<void(const std::string&)>& warn) {
  std::ifstream in(options.site, std::ios::binary);
  if (!in) return fail(ErrorCode::not_found, options.site + ": no such site file; deploy/sites has some");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  Result<sim::Site> site = sim::parse_site(text, options.site);
  if (!site) return fail(site.error());
  sim::SimBodyConfig config;
  config.site = std::move(*site);
  config.robot = options.name;
  config.seed = options.seed;
  config.day = options.day;
  config.floors_dir = options.floors;
  config.hall_dir = options.hall;
  config.truth_path = options.truth;
  config.warn = warn;
  return sim::make_sim_body(config);
}

Result<CameraFile> read_camera_file(const std::string& file, const std::string& camera) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return fail(ErrorCode::not_found, file + ": no such camera file; `weft calibrate camera` writes one");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  return parse_camera_file(text, file, camera);
}

}  // namespace

Result<std::unique_ptr<Body>> make_body(const Options& options, const std::function<void(const std::string&)>& warn) {
  if (options.body == "sim") return make_sim(options, warn);
  replay::ReplayBodyConfig config;
  config.folder = options.recording;
  config.camera = options.camera;
  config.warn = warn;
  if (options.calibration.has_value()) {
    const Result<CameraFile> file = read_camera_file(*options.calibration, options.camera);
    if (!file) return fail(file.error());
    config.robot_from_camera = file->camera.body_from_camera;
  }
  if (options.mount.has_value()) config.robot_from_camera = options.mount;
  return replay::make_replay_body(config);
}

Result<CameraModel> make_camera(const Options& options, const Body& body,
                                const std::function<void(const std::string&)>& warn, CalibrationSigma* known) {
  const std::vector<CameraModel> cameras = body.cameras();
  if (cameras.empty()) return fail(ErrorCode::invalid, "the body has no camera");
  CameraModel told = cameras.front();
  if (options.mount.has_value()) told.robot_from_camera = *options.mount;
  if (!options.calibration.has_value()) return told;
  const std::string& name = *options.calibration;
  const Result<CameraFile> file = read_camera_file(name, options.camera);
  if (!file) return fail(file.error());
  for (const std::string& part : file->not_understood) warn(part + " is not understood and not used");
  if (file->camera.width != told.width || file->camera.height != told.height) {
    const auto size = [](int width, int height) { return std::to_string(width) + " x " + std::to_string(height); };
    return fail(ErrorCode::invalid, name + ": is of a camera with " + size(file->camera.width, file->camera.height) +
                                        " pixels, the body's has " + size(told.width, told.height) +
                                        "; calibrate at the size that is driven with");
  }
  if (known != nullptr) *known = file->camera.sigma;
  CameraModel camera = camera_model_from(file->camera, told.id, told.robot_from_camera);
  if (options.mount.has_value()) camera.robot_from_camera = *options.mount;
  return camera;
}

Result<std::unique_ptr<Navigator>> make_navigator(const Options& options, const CameraModel& camera) {
  const NavigationConfig& config = options.navigation;
  if (const std::vector<Error> wrong = check(config); !wrong.empty()) return fail(wrong.front());
  Result<AnyMethod> method = make_method(options, camera);
  if (!method) return fail(method.error());
  return std::visit(
      [&](auto&& chosen) -> Result<std::unique_ptr<Navigator>> {
        return agents::make_navigator(std::forward<decltype(chosen)>(chosen), config);
      },
      std::move(*method));
}

}  // namespace weft::agents
