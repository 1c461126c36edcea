#include "agents/agent/process/equip.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>
#include <variant>

#include "agents/bodies/replay/replay_body.hpp"
#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/bearing/bearing.hpp"
#include "agents/methods/floor/floor.hpp"
#include "agents/navigation/config.hpp"
#include "agents/navigation/navigator_of.hpp"
#include "agents/navigation/several.hpp"

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

Result<AnyMethod> make_method(const Options& options, const Equipped& equipped) {
  if (equipped.method == Bearing::name) return made<Bearing>(options.bearing, equipped.camera);
  return made<Floor>(options.floor, equipped.camera);
}

Result<std::unique_ptr<Navigator>> make_one(const Options& options, const Equipped& equipped) {
  Result<AnyMethod> method = make_method(options, equipped);
  if (!method) return fail(method.error());
  return std::visit(
      [&](auto&& chosen) -> Result<std::unique_ptr<Navigator>> {
        return agents::make_navigator(std::forward<decltype(chosen)>(chosen), options.navigation);
      },
      std::move(*method));
}

std::vector<std::string> methods_of(const Options& options) {
  std::vector<std::string> methods;
  std::istringstream text(options.method);
  for (std::string method; std::getline(text, method, ',');) methods.push_back(method);
  return methods;
}

bool looks_down(const CameraModel& camera) {
  constexpr double steep = 0.34;  // 20 degrees below level
  return (camera.robot_from_camera.rotation * Eigen::Vector3d::UnitZ()).z() < -steep;
}

/// A body with one camera has no choice.
Result<CameraModel> camera_for(const std::string& method, const std::vector<CameraModel>& cameras) {
  if (cameras.empty()) return fail(ErrorCode::invalid, "the body has no camera");
  const bool down = method == Floor::name;
  const auto found = std::find_if(cameras.begin(), cameras.end(),
                                  [down](const CameraModel& camera) { return looks_down(camera) == down; });
  if (found != cameras.end()) return *found;
  if (cameras.size() == 1) return cameras.front();
  return fail(ErrorCode::invalid, "no camera of the body looks " + std::string(down ? "down" : "ahead") +
                                      ", as method " + method + " needs it");
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

namespace {

/// What is known of the camera that the body tells of.
Result<CameraModel> calibrated(const Options& options, CameraModel told,
                               const std::function<void(const std::string&)>& warn) {
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
  CameraModel camera = camera_model_from(file->camera, told.id, told.robot_from_camera);
  if (options.mount.has_value()) camera.robot_from_camera = *options.mount;
  return camera;
}

}  // namespace

Result<std::vector<Equipped>> make_cameras(const Options& options, const Body& body,
                                           const std::function<void(const std::string&)>& warn) {
  std::vector<Equipped> all;
  for (const std::string& method : methods_of(options)) {
    const Result<CameraModel> told = camera_for(method, body.cameras());
    if (!told) return fail(told.error());
    const bool is_taken =
        std::any_of(all.begin(), all.end(), [&](const Equipped& other) { return other.camera.id == told->id; });
    if (is_taken) {
      return fail(ErrorCode::invalid, "method " + options.method + ": the body has one camera, " + told->id +
                                          "; each method needs one of its own");
    }
    Equipped equipped{method, *told};
    if (all.empty()) {
      const Result<CameraModel> camera = calibrated(options, *told, warn);
      if (!camera) return fail(camera.error());
      equipped.camera = *camera;
    }
    all.push_back(std::move(equipped));
  }
  return all;
}

Result<std::unique_ptr<Navigator>> make_navigator(const Options& options, const std::vector<Equipped>& equipped) {
  if (const std::vector<Error> wrong = check(options.navigation); !wrong.empty()) return fail(wrong.front());
  std::vector<Looking> all;
  for (const Equipped& one : equipped) {
    Result<std::unique_ptr<Navigator>> navigator = make_one(options, one);
    if (!navigator) return navigator;
    all.push_back({one.camera.id, std::move(*navigator)});
  }
  if (all.size() == 1) return std::move(all.front().navigator);
  return make_several(std::move(all), options.navigation);
}

}  // namespace weft::agents
