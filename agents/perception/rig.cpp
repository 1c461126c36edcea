#include "agents/perception/rig.hpp"

#include <algorithm>
#include <utility>

namespace weft::agents {
namespace {

std::string article(const SensorNeed& need) {
  return need.count == 1 ? std::string("a ") + to_string(need.kind)
                         : std::to_string(need.count) + " " + to_string(need.kind);
}

std::string said(const SensorNeed& need) {
  const char* const sensors = need.kind == SensorKind::stereo ? (need.count == 1 ? " sensor" : " sensors")
                              : need.count == 1               ? ""
                                                              : "s";
  return article(need) + sensors + (need.count == 1 ? " that looks " : " that look ") + to_string(need.gaze);
}

std::string said(const Rig& rig, const std::vector<std::string>& taken) {
  std::string all;
  for (const Sensor& sensor : rig.sensors) {
    const bool is_taken = std::find(taken.begin(), taken.end(), sensor.id) != taken.end();
    all += (all.empty() ? "" : ", ") + sensor.id + " (" + to_string(sensor.kind) + ", " + to_string(sensor.gaze()) +
           (is_taken ? ", used by another method)" : ")");
  }
  return all.empty() ? "no sensor" : all;
}

}  // namespace

const char* to_string(SensorKind kind) {
  return kind == SensorKind::camera ? "camera" : "stereo";
}

const char* to_string(Gaze gaze) {
  switch (gaze) {
    case Gaze::down:
      return "down";
    case Gaze::ahead:
      return "ahead";
    case Gaze::up:
      break;
  }
  return "up";
}

Gaze gaze_of(const CameraModel& camera) {
  constexpr double below = -0.34;
  constexpr double above = 0.7;
  const double axis_z = (camera.robot_from_camera.rotation * Eigen::Vector3d::UnitZ()).z();
  return axis_z < below ? Gaze::down : axis_z > above ? Gaze::up : Gaze::ahead;
}

const Sensor* Rig::find(std::string_view id) const {
  const auto found = std::find_if(sensors.begin(), sensors.end(), [id](const Sensor& one) { return one.id == id; });
  return found == sensors.end() ? nullptr : &*found;
}

Rig rig_of(CameraModel camera) {
  std::string id = camera.id;
  return {{Sensor{std::move(id), SensorKind::camera, std::move(camera)}}};
}

Result<Rig> choose(const Rig& rig, const SensorNeed& need, std::string_view method,
                   const std::vector<std::string>& taken) {
  Rig chosen;
  for (const Sensor& sensor : rig.sensors) {
    if (chosen.sensors.size() == need.count) break;
    if (sensor.kind != need.kind || sensor.gaze() != need.gaze) continue;
    if (std::find(taken.begin(), taken.end(), sensor.id) == taken.end()) chosen.sensors.push_back(sensor);
  }
  if (chosen.sensors.size() == need.count) return chosen;
  return fail(ErrorCode::invalid,
              "method " + std::string(method) + " needs " + said(need) + "; the body has: " + said(rig, taken));
}

}  // namespace weft::agents
