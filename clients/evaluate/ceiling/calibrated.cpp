#include "clients/evaluate/ceiling/calibrated.hpp"

#include <utility>

#include "agents/methods/ceiling/mount_drive.hpp"
#include "clients/evaluate/ceiling/way.hpp"
#include "clients/evaluate/floor/calibrated.hpp"

namespace weft::evaluate::ceiling {

using namespace agents;

namespace {
constexpr std::uint64_t kMostDrives = 3;
}  // namespace

Result<std::optional<Calibrated>> calibrated(const Scenes& scenes, const sim::Site& site, const Driven& driven) {
  sim::RobotStart robot = start_of(site, driven.robot);
  robot.site_from_robot = beginning_of(scenes.calibration.line);
  robot.ceiling_camera = robot.ceiling_camera.value_or(site.ceiling_camera);
  sim::Site ground = scenes.calibration.site;
  ground.robots = {robot};
  Driven before = driven;
  before.day = 0;

  const CeilingConfig by_tape = settings_in(ground, driven.seed);
  MountDriveConfig config;
  config.plane_m = by_tape.height_m;
  config.prior.focal_share = ground.disturbances.focal_error;
  Result<std::optional<MountDrive>> found = std::optional<MountDrive>();
  for (std::uint64_t drive = 0; drive < kMostDrives; ++drive) {
    before.day = drive;
    found = floor::mount_by_hand(drive_of(ground, before, {by_tape, {}}), scenes.calibration.line,
                                 calibrate_ceiling_mount, config);
    if (found) break;
  }
  if (!found) return fail(found.error().code, driven.robot + ": " + found.error().message);
  if (!*found) return std::optional<Calibrated>();

  return std::optional(Calibrated{settings_in(site, driven.seed), (*found)->camera});
}

}  // namespace weft::evaluate::ceiling
