#include "agents/methods/floor/mount_drive.hpp"

#include "agents/methods/floor/floor.hpp"
#include "agents/methods/see_drive.hpp"

namespace weft::agents {

Result<MountDrive> calibrate_floor_mount(const CameraModel& given, const PlayDrive& play,
                                         const MountDriveConfig& config) {
  const SeeDrive see = [&](const CameraModel& camera, double /*plane_m*/) -> Result<DriveSeen> {
    const Result<Floor> floor = Floor::make({}, camera);
    if (!floor) return fail(floor.error());
    return see_drive(*floor, play);
  };
  return find_mount(given, see, config);
}

}  // namespace weft::agents
