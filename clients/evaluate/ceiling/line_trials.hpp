#pragma once
#include <optional>

#include "clients/evaluate/ceiling/score.hpp"
#include "clients/evaluate/ceiling/way.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Scores a taught line and has the same robot drive it the next day, and, as a baseline, by the law that was
/// published. None: stopped.
Result<std::optional<Measured>> measure_line(const Way& way, const Driven& driven);

/// Has another robot drive the line: r2, with another lens, another place and tilt of the camera, whose mount has
/// been knocked by 0.3 degrees since it was calibrated. None: stopped.
Result<std::optional<Measured>> measure_other(const Way& way, const Driven& driven, const Scenes& scenes);

/// Has the same robot drive the line when a duct hangs across it that was not there, the sun stands in the skylights
/// and a person and a forklift with raised forks move beside it. None: stopped.
Result<std::optional<Measured>> measure_change(const Way& way, const Driven& driven);

/// Returns the point of the ceiling that a camera has in the middle of its image, in the robot's frame.
Eigen::Vector2d middle_of_view(const agents::CameraModel& camera, double ceiling_m);

/// Returns how far off the robot would be that takes the middle of its image for its own place, in both views
/// (Lucas et al., III): RMS over the fixes of a drive, metres; NaN without fixes. `taught_by` and `driven_by` are the
/// cameras as they are told.
double centroid_rms_m(const floor::Trace& trace, const std::map<PlaceId, Pose2>& site_from_place,
                      const agents::CameraModel& taught_by, const agents::CameraModel& driven_by, double ceiling_m);

}  // namespace weft::evaluate::ceiling
