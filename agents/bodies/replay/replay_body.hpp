#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "agents/bodies/body.hpp"

namespace weft::agents::replay {

struct ReplayBodyConfig {
  std::string folder;  ///< EuRoC layout: mav0/CAMERA/data.csv, data/*.png, sensor.yaml (docs/formats/camera.md)
  std::string camera = "cam0";                   ///< which of its cameras
  std::optional<Pose3> robot_from_camera;        ///< the mount; without one the recording's own T_BS
  std::function<void(const std::string&)> warn;  ///< optional; frames that were dropped, by file
};

/// A recording as a body: kind() is "replay". It has wheels where there is a mav0/wheels0/data.csv (rows
/// "nanoseconds,metres,radians" since any beginning), and obeys no command; `step` brings the next image, a
/// damaged one as a dropped frame with a warning, and after the last "recording is over" (unavailable).
/// not_found: folder, data.csv or sensor.yaml missing; invalid: their text, by file and line.
Result<std::unique_ptr<Body>> make_replay_body(const ReplayBodyConfig& config);

}  // namespace weft::agents::replay
