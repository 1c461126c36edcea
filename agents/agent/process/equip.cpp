#include "agents/agent/process/equip.hpp"

#include <utility>

#include "agents/agent/process/read_camera_file.hpp"
#include "agents/methods/all.hpp"
#include "agents/navigation/config.hpp"
#include "agents/navigation/multi_method_navigator.hpp"
#include "agents/navigation/navigator_of.hpp"

namespace weft::agents {
namespace {

Result<std::unique_ptr<Navigator>> make_one(const Options& options, const Equipped& equipped, bool is_alone) {
  Result<std::unique_ptr<Navigator>> made = fail(ErrorCode::invalid, "there is no method " + equipped.method);
  AllMethods::for_each([&]<class M>() {
    if (equipped.method != M::name) return;
    const Configured<M>& settings = std::get<Configured<M>>(options.settings);
    if (const std::vector<Error> wrong = check(settings.navigation); !wrong.empty()) {
      made = fail(wrong.front());
      return;
    }
    Result<M> method = M::make(settings.config, equipped.rig);
    if (!method) {
      made = fail(method.error());
      return;
    }
    const std::string sensor = is_alone ? std::string() : equipped.rig.sensors.front().id;
    made = agents::make_navigator(std::move(*method), settings.navigation, sensor);
  });
  return made;
}

/// Returns what a method needs; it is one of AllMethods.
SensorNeed need_of(const std::string& method) {
  SensorNeed need;
  AllMethods::for_each([&]<class M>() {
    if (method == M::name) need = M::needs;
  });
  return need;
}

/// Returns a camera of the calibration file of the options instead of `told`, which it has to fit. What else the
/// file holds is warned of.
Result<CameraCalibration> calibration_of(const Options& options, const std::string& name, const CameraModel& told,
                                         const std::function<void(const std::string&)>& warn) {
  const std::string& path = *options.calibration;
  const Result<CameraFile> file = read_camera_file(path, name);
  if (!file) return fail(file.error());
  for (const std::string& part : file->not_understood) warn(part + " is not understood and not used");
  if (file->camera.width == told.width && file->camera.height == told.height) return file->camera;
  const auto size = [](int width, int height) { return std::to_string(width) + " x " + std::to_string(height); };
  return fail(ErrorCode::invalid, path + ": is of a camera with " + size(file->camera.width, file->camera.height) +
                                      " pixels, the body's has " + size(told.width, told.height) +
                                      "; calibrate at the size that is driven with");
}

/// Returns whether --camera names several sensors: a calibration file then has all of them, by these names.
bool names_several(const Options& options) {
  return options.camera.find(',') != std::string::npos;
}

/// Returns what is known of the sensor that the body tells of. Of a stereo sensor the file holds both halves, by the
/// names of --camera (cam0+cam1), where that names several sensors those of this one: the right one where its own
/// mount says, or its place beside the one before it in a chain, or else where the body has it beside the left one.
Result<Sensor> calibrated(const Options& options, Sensor told, const std::function<void(const std::string&)>& warn) {
  const Pose3 left_from_right =
      told.right ? told.camera.robot_from_camera.inverse() * told.right->robot_from_camera : Pose3{};
  const std::string names = names_several(options) ? told.id : options.camera;
  const std::size_t plus = told.right ? names.find('+') : std::string::npos;
  if (options.calibration) {
    const Result<CameraCalibration> left = calibration_of(options, names.substr(0, plus), told.camera, warn);
    if (!left) return fail(left.error());
    told.camera = camera_model_from(*left, told.camera.id, told.camera.robot_from_camera);
  }
  if (options.mount) told.camera.robot_from_camera = *options.mount;
  if (!told.right) return told;
  Pose3 beside = left_from_right;
  if (options.calibration && plus != std::string::npos) {
    const Result<CameraCalibration> right = calibration_of(options, names.substr(plus + 1), *told.right, warn);
    if (!right) return fail(right.error());
    told.right = camera_model_from(*right, told.right->id, {});
    if (right->previous_from_camera) beside = *right->previous_from_camera;
    if (right->body_from_camera && !options.mount) {
      told.right->robot_from_camera = *right->body_from_camera;
      return told;
    }
  }
  told.right->robot_from_camera = told.camera.robot_from_camera * beside;
  return told;
}

}  // namespace

Result<std::vector<Equipped>> equip(const Options& options, const Body& body,
                                    const std::function<void(const std::string&)>& warn) {
  std::vector<Equipped> all;
  std::vector<std::string> taken;
  for (const std::string& method : options.methods) {
    Result<Rig> rig = choose(body.rig(), need_of(method), method, taken);
    if (!rig) return fail(rig.error());
    for (const Sensor& sensor : rig->sensors) taken.push_back(sensor.id);
    if (all.empty() || names_several(options)) {
      Result<Sensor> sensor = calibrated(options, rig->sensors.front(), warn);
      if (!sensor) return fail(sensor.error());
      rig->sensors.front() = std::move(*sensor);
    }
    all.push_back({method, std::move(*rig)});
  }
  return all;
}

Result<std::unique_ptr<Navigator>> make_navigator(const Options& options, const std::vector<Equipped>& equipped,
                                                  const Rig& rig) {
  if (const std::vector<Error> wrong = check(options.navigation); !wrong.empty()) return fail(wrong.front());
  // Samples of a body with more sensors are not all of this one's: what it did not see has moved it all the same.
  const bool is_alone = equipped.size() == 1 && rig.sensors.size() == 1;
  std::vector<SensorNavigator> all;
  for (const Equipped& one : equipped) {
    Result<std::unique_ptr<Navigator>> navigator = make_one(options, one, is_alone);
    if (!navigator || is_alone) return navigator;
    all.push_back({one.rig.sensors.front().id, std::move(*navigator)});
  }
  return make_multi_method_navigator(std::move(all), options.navigation);
}

}  // namespace weft::agents
