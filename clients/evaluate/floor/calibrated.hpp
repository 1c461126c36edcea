#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "clients/evaluate/floor/drive.hpp"

namespace weft::evaluate::floor {

/// Returns the camera as `weft calibrate mount` finds it (agents/methods/floor/mount_drive.hpp) when a hand leads the
/// robot along the line and somebody measures with a tape, good to 2 mm, how far it ended from where it began. None:
/// stopped. Errors of the body and of the calibration.
Result<std::optional<agents::CameraModel>> calibrated(const Drive& drive, const std::vector<agents::SitePoint>& line);

}  // namespace weft::evaluate::floor
