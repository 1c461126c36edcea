#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "agents/methods/ceiling/ceiling.hpp"
#include "clients/evaluate/ceiling/frames/recording.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Holds what the method has made of a recording, frame by frame.
struct Tracked {
  std::vector<Pose2> start_from_robot;
  std::vector<std::optional<agents::CeilingContent>> contents;  ///< none: it had nothing to store there
  std::size_t lost = 0;  ///< frames after the first one whose motion it did not see
};

/// Returns the recording's camera with the mount that its images show: leaning as `find_tilt` says, and turned so
/// that most of the way leads ahead, as a robot drives; its sigma says how well the tilt is known. refused: too
/// little moves to see how it leans.
Result<agents::CameraModel> mounted(const Recording& recording);

/// Has the method watch the recording with that camera, told the ceiling's height and nothing else: no wheels, and as
/// command what the step before has shown. None: stopped. Errors of the method.
Result<std::optional<Tracked>> track(const Recording& recording, const agents::CameraModel& camera,
                                     const std::function<bool()>& asked_to_stop);

}  // namespace weft::evaluate::ceiling
