#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/motion.hpp"
#include "agents/perception/mount.hpp"
#include "agents/perception/view.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Sets how well odometry below a ceiling keeps its scale, 1 sigma, a share: what hangs is taken for the ceiling
/// until heights have been told, the same way on every drive.
inline constexpr double kCeilingScale = 0.005;

/// Plays a short drive, from its first sample to its last, at each call; view null: a dropped frame.
using PlayDrive = std::function<Result<void>(const std::function<void(const View*, const Motion&)>& take)>;

/// Holds what one pass through a drive has shown of the plane that the camera looks at.
struct DriveSeen {
  std::vector<PlaneViews> views;
  Pose2 first_from_last;
  double path_m = 0.0;
  double wheels_m = 0.0;       ///< over stretches with wheels, and...
  double seen_beside_m = 0.0;  ///< ...what vision says of the same
  std::size_t samples = 0;
  std::size_t blind = 0;
};

/// Goes once through the drive, as seen by that camera with its plane at that height above the floor.
using SeeDrive = std::function<Result<DriveSeen>(const CameraModel& camera, double plane_m)>;

struct MountDriveConfig {
  MountPrior prior;
  double plane_m = 0.0;              ///< the plane above the floor: 0 the floor itself, else the ceiling, as guessed
  std::optional<double> distance_m;  ///< straight from where the robot stood first to where it stood last, measured
  double distance_sigma_m = 0.005;   ///< of that measurement
  std::optional<double> wheels_sigma;  ///< 1 sigma of the wheel odometry's scale, a share; none: not to be used
  double least_drive_m = 2.0;          ///< less is refused
  double most_blind_share = 0.1;       ///< of the samples after the first
  double most_tilt_sigma_rad = 0.005;  ///< pitch and roll worse than this are refused
};

enum class HeightFrom { nothing, distance, wheels };

struct MountDrive {
  /// Holds the camera with the mount that was found and how well it is known; scale_share is none when the height was
  /// not observable, or is the ceiling's.
  CameraModel camera;
  double pitch_rad = 0.0;  ///< found less given
  double roll_rad = 0.0;
  MountLever lever;           ///< yaw and forward against the given mount
  bool yaw_seen = false;      ///< its sigma is less than half of what was known before
  bool forward_seen = false;  ///< likewise: the drive had turns
  HeightFrom height_from = HeightFrom::nothing;
  double height_share = 0.0;          ///< camera to plane, found over given, less one; 0 when it was not observable
  std::optional<double> scale_sigma;  ///< 1 sigma of distances, a share; none: the height was not observable
  double plane_m = 0.0;               ///< the plane above the floor, as found
  double seen_m = 0.0;                ///< straight from first to last, with the given height
  double path_m = 0.0;                ///< driven
  std::size_t pairs = 0;
  std::size_t samples = 0;
  std::size_t blind = 0;

  /// Returns 1 sigma of `plane_m` below a ceiling, metres; none: it is as it was guessed.
  std::optional<double> plane_sigma_m() const;
};

/// Finds the camera's mount from one drive: pitch and roll from what it sees of its plane, yaw and place ahead from
/// its base's not sliding sideways; the distance from the camera to the plane from the measured distance, or else
/// from the wheels, or else as given and said to be unobservable. Above the floor it is the camera that is moved,
/// below a ceiling the ceiling. Goes through the drive several times. refused: too short, too blind, too little seen
/// for pitch and roll; names the bound and what to do.
Result<MountDrive> find_mount(const CameraModel& given, const SeeDrive& see, const MountDriveConfig& config);

}  // namespace weft::agents
