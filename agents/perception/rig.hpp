#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "core/result.hpp"

namespace weft::agents {

enum class SensorKind : std::uint8_t { camera, stereo };
const char* to_string(SensorKind kind);

/// Names the direction in which a sensor looks, by its optical axis in the robot's frame.
enum class Gaze : std::uint8_t {
  down,   ///< more than 20 degrees below level
  ahead,  ///< between
  up      ///< more than 44 degrees above level
};
const char* to_string(Gaze gaze);
Gaze gaze_of(const CameraModel& camera);

/// Describes one sensor of a body, as it is known; a simulated body's true one differs.
struct Sensor {
  std::string id;  ///< as `View::sensor` has it
  SensorKind kind = SensorKind::camera;
  CameraModel camera;                     ///< of a stereo sensor the left one
  std::optional<CameraModel> right = {};  ///< of a stereo sensor

  Gaze gaze() const { return gaze_of(camera); }
};

/// Holds all that a body looks with.
struct Rig {
  std::vector<Sensor> sensors;

  /// Returns the sensor of that id; null: there is none.
  const Sensor* find(std::string_view id) const;
  /// Returns the only sensor's camera, for what has one. The rig is not empty.
  const CameraModel& camera() const { return sensors.front().camera; }
};
/// Returns a rig of one camera, whose id is also the sensor's.
Rig rig_of(CameraModel camera);

/// States which sensors a method looks through.
struct SensorNeed {
  SensorKind kind = SensorKind::camera;
  Gaze gaze = Gaze::down;
  std::size_t count = 1;
};

/// Returns the first sensors of the rig that are what `method` needs and that nobody has `taken`. invalid: there are
/// too few; names what is needed and what there is.
Result<Rig> choose(const Rig& rig, const SensorNeed& need, std::string_view method,
                   const std::vector<std::string>& taken);

}  // namespace weft::agents
