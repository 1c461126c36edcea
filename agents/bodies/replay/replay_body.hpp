#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "agents/bodies/body.hpp"

namespace weft::agents::replay {

struct ReplayBodyConfig {
  std::string folder;           ///< EuRoC's layout or KITTI's (recorded_sensors.hpp)
  std::string camera = "cam0";  ///< its sensors: "cam0", several with commas between, "cam0+cam1" for a stereo pair
  std::optional<Pose3> robot_from_camera;        ///< the first one's mount; without it the recording's own T_BS
  std::function<void(const std::string&)> warn;  ///< optional; frames that were dropped, by file
};

/// Returns a recording as a body: kind() is "replay". It has wheels where there is a mav0/wheels0/data.csv (rows
/// "nanoseconds,metres,radians" since any beginning), and obeys no command. `step` brings the next images, those
/// together that are within a millisecond; a damaged one, or half a pair, is a dropped frame with a warning; after
/// the last "recording is over" (unavailable, or corrupt where something was dropped). not_found: folder or a file
/// missing; invalid: their text, by file and line.
Result<std::unique_ptr<Body>> make_replay_body(const ReplayBodyConfig& config);

}  // namespace weft::agents::replay
