#pragma once
#include "agents/perception/mount_drive.hpp"

namespace weft::agents {

/// Finds the mount of a camera that looks up, by the ceiling as the method `ceiling` follows it, `config.plane_m`
/// above the floor as guessed: `find_mount`, where corners that hang lower weigh as little as their heights are
/// known. A tilt that the camera states a sigma of is that well known before the drive. The camera's own height stays
/// as given; what a measured distance or wheels show is the ceiling's. Errors as of `find_mount`, and of a camera or
/// a ceiling that `ceiling` does not take.
Result<MountDrive> calibrate_ceiling_mount(const CameraModel& given, const PlayDrive& play,
                                           const MountDriveConfig& config);

}  // namespace weft::agents
