#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "agents/bodies/body.hpp"
#include "agents/perception/rig.hpp"
#include "core/result.hpp"
#include "storage/formats/trajectory.hpp"

namespace weft::evaluate::stereo {

/// Bounds the pairs of a recording: fewer tell nothing, and paths are kept in memory.
inline constexpr std::size_t kFewestPairs = 5;
inline constexpr std::size_t kMostPairs = 100'000;

/// Describes a recorded pair of cameras, and where it truly was.
struct Recording {
  std::filesystem::path folder;
  std::string name;  ///< of the folder
  agents::Sensor sensor;
  std::size_t pairs = 0;
  formats::Trajectory truth;  ///< of the robot's frame: EuRoC's body, KITTI's left camera
};

/// Reads a recording's calibration and truth, laid out as EuRoC's (mav0/cam0, mav0/cam1) or KITTI's (calib.txt,
/// image_l, image_r, poses.txt). `truth`: another file of it; empty: EuRoC's is one of those that `recorded_truth`
/// knows, KITTI's poses.txt. `warn` is told what is passed over. not_found: the folder is laid out otherwise, or a
/// file is missing; invalid: too few or too many pairs, fewer poses than images, or a file's text. Each names the
/// file, and the line.
Result<Recording> read_recording(const std::filesystem::path& folder, const std::filesystem::path& truth,
                                 const std::function<void(const std::string&)>& warn);

/// Returns the recording as a body, to be played from its beginning; `warn` is told which pairs are dropped, and why.
Result<std::unique_ptr<agents::Body>> play(const Recording& recording,
                                           const std::function<void(const std::string&)>& warn);

}  // namespace weft::evaluate::stereo
