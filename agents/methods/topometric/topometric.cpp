#include "agents/methods/topometric/topometric.hpp"

#include <string>
#include <utility>

#include "agents/methods/topometric/sight.hpp"
#include "agents/perception/lens.hpp"

namespace weft::agents {

static_assert(Method<Topometric> && Registers<Topometric>);

Topometric::Topometric(const TopometricConfig& config, OpenOdometry odometry)
    : config_(config), odometry_(std::move(odometry)) {
  config_.scan = scan_of_pair(config.scan, config.sight, config.disparity, rig());
}

Result<Topometric> Topometric::make(const TopometricConfig& config, const Rig& rig) {
  if (const std::vector<std::string> issues = check(config); !issues.empty()) {
    std::string all;
    for (const std::string& issue : issues) all += (all.empty() ? "" : "; ") + issue;
    return fail(ErrorCode::invalid, all);
  }
  if (rig.sensors.empty())
    return fail(ErrorCode::invalid, "topometric: the rig has no sensor; it needs a stereo pair");
  const Sensor& sensor = rig.sensors.front();
  if (const Result<void> sound = check(sensor.camera); !sound) return fail(sound.error());
  if (sensor.gaze() != Gaze::ahead)
    return fail(ErrorCode::invalid, "stereo sensor \"" + sensor.id + "\" does not look ahead; correct its mount");
  Result<OpenOdometry> odometry = OpenOdometry::make(config.open, sensor);
  if (!odometry) return fail(odometry.error());
  return Topometric(config, std::move(*odometry));
}

}  // namespace weft::agents
