#pragma once
#include <functional>
#include <optional>

#include "agents/methods/floor/config.hpp"
#include "agents/perception/camera_model.hpp"
#include "agents/perception/motion.hpp"
#include "agents/perception/mount.hpp"
#include "agents/perception/view.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Plays a short drive, from its first sample to its last, at each call; view null: a dropped frame.
using PlayDrive = std::function<Result<void>(const std::function<void(const View*, const Motion&)>& take)>;

struct MountDriveConfig {
  FloorConfig floor;
  MountPrior prior;
  std::optional<double> distance_m;    ///< straight from where the robot stood first to where it stood last, measured
  double distance_sigma_m = 0.005;     ///< of that measurement
  std::optional<double> wheels_sigma;  ///< 1 sigma of the wheel odometry's scale, a share; none: not to be used
  double least_drive_m = 2.0;          ///< less is refused
  double most_blind_share = 0.1;       ///< of the samples after the first
  double most_tilt_sigma_rad = 0.005;  ///< pitch and roll worse than this are refused
};

enum class HeightFrom { nothing, distance, wheels };

struct MountDrive {
  /// Holds the camera with the mount that was found and how well it is known; scale_share is none when the height was
  /// not observable.
  CameraModel camera;
  double pitch_rad = 0.0;  ///< found less given
  double roll_rad = 0.0;
  MountLever lever;           ///< yaw and forward against the given mount
  bool yaw_seen = false;      ///< its sigma is less than half of what was known before
  bool forward_seen = false;  ///< likewise: the drive had turns
  HeightFrom height_from = HeightFrom::nothing;
  double height_share = 0.0;  ///< found over given, less one; 0 when it was not observable
  double seen_m = 0.0;        ///< straight from first to last, with the given height
  double path_m = 0.0;        ///< driven
  std::size_t pairs = 0;
  std::size_t samples = 0;
  std::size_t blind = 0;
};

/// Finds the camera's mount from one drive: pitch and roll from what it sees of the floor, yaw and place ahead from
/// its base's not sliding sideways, height from the measured distance, or else from the wheels, or else as given and
/// said to be unobservable. Plays the drive several times. refused: too short, too blind, too little seen for pitch
/// and roll; names the bound and what to do.
Result<MountDrive> calibrate_mount(const CameraModel& given, const PlayDrive& play, const MountDriveConfig& config);

}  // namespace weft::agents
