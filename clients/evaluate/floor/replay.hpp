#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Says where a recording's camera was mounted: in front of and left of the robot's middle, above the floor, and how
/// far it looked down from level.
struct ReplayMount {
  double forward_m = 0.0;
  double left_m = 0.0;
  double height_m = 0.0;
  double pitch_deg = 0.0;
};

struct ReplayOptions {
  std::filesystem::path recording;  ///< folder in EuRoC layout
  std::filesystem::path query;      ///< another recording, to be localised in the first; empty: the first one again
  std::filesystem::path truth;      ///< a trajectory, TUM (.txt) or EuRoC (.csv); empty: where recordings have one
  std::string camera = "cam0";
  std::optional<ReplayMount> mount;  ///< none: the recording's own
  std::filesystem::path out;         ///< folder; made if it is not there
};

namespace floor {

/// Replays a recording: odometry while it is mapped, then localisation of the query in that map, frame by frame; both
/// held against the trajectory where there is one. Prints a table, writes replay.json and replay.png. Errors of the
/// recording, of the camera (floor needs one that looks down) and of the trajectory; unavailable: `out`.
Result<Ended> replay_floor(const ReplayOptions& options, const Surroundings& around);

}  // namespace floor
}  // namespace weft::evaluate
