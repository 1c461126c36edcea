#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "agents/perception/mount_drive.hpp"
#include "clients/evaluate/floor/drive.hpp"

namespace weft::evaluate::floor {

/// Finds a mount from a drive that can be played again, as one method's part of `weft calibrate mount` does.
using FindMount = std::function<Result<agents::MountDrive>(
    const agents::CameraModel& given, const agents::PlayDrive& play, const agents::MountDriveConfig& config)>;

/// Returns what `find` makes of a drive in which a hand leads the robot along the line and somebody measures with a
/// tape, good to 2 mm, how far it ended from where it began. None: stopped. Errors of the body and of `find`.
Result<std::optional<agents::MountDrive>> mount_by_hand(const Drive& drive,
                                                        const std::vector<agents::SitePoint>& line,
                                                        const FindMount& find, agents::MountDriveConfig config);

/// Returns the camera as `weft calibrate mount` finds it (agents/methods/floor/mount_drive.hpp) on such a
/// drive. None: stopped. Errors of the body and of the calibration.
Result<std::optional<agents::CameraModel>> calibrated(const Drive& drive, const std::vector<agents::SitePoint>& line);

}  // namespace weft::evaluate::floor
