#include "agents/methods/ceiling/mount_drive.hpp"

#include <algorithm>

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/methods/see_drive.hpp"

namespace weft::agents {

Result<MountDrive> calibrate_ceiling_mount(const CameraModel& given, const PlayDrive& play,
                                           const MountDriveConfig& config) {
  // Ducts along one side of the way look like a ceiling that leans. While the tilt is hardly known they are taken for
  // the ceiling's, and the heights found with that lean confirm it later. So the tilt of the camera's file is
  // believed from the first, with room for a knock since.
  constexpr double knocked_rad = 0.004;
  MountDriveConfig known = config;
  if (given.sigma.tilt_rad)
    known.prior.tilt_rad = std::min(config.prior.tilt_rad, std::max(*given.sigma.tilt_rad, knocked_rad));
  const SeeDrive see = [&](const CameraModel& camera, double plane_m) -> Result<DriveSeen> {
    CeilingConfig settings;
    settings.height_m = plane_m;
    // Odometry itself gives mounts three times as much. From the second time on the first has told the tilt, and the
    // camera brings it: heights are believed, without which what hangs makes the ceiling seem lower than it is.
    if (!camera.sigma.tilt_rad) settings.mount_tilt_rad = known.prior.tilt_rad / 3.0;
    const Result<Ceiling> ceiling = Ceiling::make(settings, camera);
    if (!ceiling) return fail(ceiling.error());
    return see_drive(*ceiling, play);
  };
  return find_mount(given, see, known);
}

}  // namespace weft::agents
