#include "agents/methods/ceiling/mount_drive.hpp"

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/methods/see_drive.hpp"

namespace weft::agents {

Result<MountDrive> calibrate_ceiling_mount(const CameraModel& given, const PlayDrive& play,
                                           const MountDriveConfig& config) {
  const SeeDrive see = [&](const CameraModel& camera, double plane_m) -> Result<DriveSeen> {
    CeilingConfig settings;
    settings.height_m = plane_m;
    // Odometry itself gives mounts three times as much. From the second time on the first has told the tilt, and the
    // camera brings it: heights are believed, without which what hangs makes the ceiling seem lower than it is.
    if (!camera.sigma.tilt_rad) settings.mount_tilt_rad = config.prior.tilt_rad / 3.0;
    const Result<Ceiling> ceiling = Ceiling::make(settings, camera);
    if (!ceiling) return fail(ceiling.error());
    return see_drive(*ceiling, play);
  };
  return find_mount(given, see, config);
}

}  // namespace weft::agents
