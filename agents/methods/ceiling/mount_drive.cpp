#include "agents/methods/ceiling/mount_drive.hpp"

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/methods/see_drive.hpp"

namespace weft::agents {

Result<MountDrive> calibrate_ceiling_mount(const CameraModel& given, const PlayDrive& play,
                                           const MountDriveConfig& config) {
  const SeeDrive see = [&](const CameraModel& camera, double plane_m) -> Result<DriveSeen> {
    CeilingConfig settings;
    settings.height_m = plane_m;
    settings.mount_tilt_rad = config.prior.tilt_rad / 3.0;  // odometry itself gives mounts three times as much
    const Result<Ceiling> ceiling = Ceiling::make(settings, camera);
    if (!ceiling) return fail(ceiling.error());
    return see_drive(*ceiling, play);
  };
  return find_mount(given, see, config);
}

}  // namespace weft::agents
