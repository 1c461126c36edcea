#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "agents/perception/rig.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::agents::replay {

/// Holds one moment at which a sensor fired: the paths of its image, or of both images of a pair. An empty path is
/// half a pair that was not recorded.
struct Shot {
  SensorTime time{};
  std::string left;
  std::string right;
};

struct RecordedSensor {
  Sensor sensor;
  std::vector<Shot> shots;  ///< in the order of time
};

/// Names the sensors of a recording that are to be played.
struct WantedSensors {
  std::string folder;
  std::string names;                       ///< "cam0"; "cam0,cam1" are two sensors, "cam0+cam1" a stereo pair
  std::optional<Pose3> robot_from_camera;  ///< mount of the first one; the others stay where they are beside it
  std::function<void(const std::string&)> warn;
};

/// Reads what the sensors of a recording have seen, and their calibration. Two layouts are known: EuRoC's
/// (mav0/NAME/data.csv, sensor.yaml and data/; the first two may lie beside mav0 as NAME_data.csv and
/// NAME_sensor.yaml; where there is no data.csv, the images' names are their times in nanoseconds, which is warned
/// of), and KITTI's odometry (calib.txt, image_l/ and image_r/, times.txt), which has one sensor, the pair
/// image_l+image_r or one half of it, and whose images are ten a second where there is no times.txt, which is warned
/// of. Rows of a pair belong together whose times agree within a millisecond. not_found, invalid: names the file, and
/// the line.
Result<std::vector<RecordedSensor>> read_sensors(const WantedSensors& wanted);

}  // namespace weft::agents::replay
