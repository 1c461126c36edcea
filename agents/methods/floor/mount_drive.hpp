#pragma once
#include "agents/perception/mount_drive.hpp"

namespace weft::agents {

/// Finds the mount of a camera that looks down, by the floor as the method `floor` follows it: `find_mount` with the
/// plane of the floor. Errors as of that, and of a camera that `floor` does not take.
Result<MountDrive> calibrate_floor_mount(const CameraModel& given, const PlayDrive& play,
                                         const MountDriveConfig& config);

}  // namespace weft::agents
