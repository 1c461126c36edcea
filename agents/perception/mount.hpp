#pragma once
#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/planar_motion.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Holds two views of one drive on the same floor or under the same ceiling, a tenth of a metre or more apart.
struct PlaneViews {
  std::vector<PlanePair> points;
  Pose2 a_from_b;               ///< of the robot, as it was estimated with the mount that was believed then
  std::optional<Pose2> wheels;  ///< the same by wheel odometry; none: there is none, or not all the way
};

struct MountPrior {
  double tilt_rad = 0.1;               ///< 1 sigma of pitch and roll before anything was seen
  double focal_share = 0.003;          ///< 1 sigma of the given focal length
  double vibration_tilt_rad = 0.0009;  ///< RMS of each view's own pitch and roll
  double vibration_height_m = 0.001;
};

/// Describes a mount's tilt against the given one, about the camera's centre: nose down by pitch, left up by roll.
struct MountTilt {
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< what the focal length's sigma does to them included
  Eigen::Matrix2d found = Eigen::Matrix2d::Zero();       ///< likewise, with the focal length as given
  double sigma_rad() const { return std::sqrt(covariance.diagonal().maxCoeff()); }
};

/// Returns the same camera with its mount turned by pitch and roll about its own centre; applies no focal share.
CameraModel tilted(const CameraModel& camera, double pitch_rad, double roll_rad);

/// Estimates a mount's tilt against `camera` from views: an information filter, where the unknowns of each pair of
/// views (motion, and both views' vibration) are eliminated. One camera over a plane sees its tilt in the perspective
/// of every motion (the normal of Gadd & Newman, eq. 2); its height it cannot see. The focal length could be seen
/// where the robot turns, but tracking's own bias makes that 0.5 % wrong (simulated;
/// docs/decisions/021-mount-from-a-drive.md): it is held as given, and its sigma is counted. Is a value: copying is
/// cheap.
class MountFilter {
 public:
  MountFilter(const CameraModel& camera, const MountPrior& prior);

  /// Learns from views. Returns false when they do not fit one plane, and nothing is learnt of them.
  bool add(const PlaneViews& views);

  /// Forgets: keeps this share of what is known.
  void fade(double share);

  MountTilt tilt() const;
  std::size_t pairs() const { return pairs_; }

 private:
  CameraModel camera_;
  MountPrior prior_;
  Eigen::Matrix3d information_;                         ///< of pitch, roll, focal share
  Eigen::Vector2d weighted_ = Eigen::Vector2d::Zero();  ///< tilt's information times its mean, focal length as given
  std::size_t pairs_ = 0;
};

/// Reports what a robot finds out about its mount while it drives.
struct MountReport {
  MountTilt tilt;  ///< against the calibration
  std::size_t pairs = 0;
  /// Is the height by the wheels over the calibration's, less one: as good as the wheels' scale. None: no wheels.
  std::optional<double> height_by_wheels;
};

/// Keeps the same filter for as long as a robot runs: what is older than about 30 m of driving fades, as mounts get
/// knocked.
class MountWatch {
 public:
  MountWatch(const CameraModel& camera, const MountPrior& prior) : filter_(camera, prior) {}
  void add(const PlaneViews& views);
  /// Returns the tilt, as far as it is known by now.
  MountTilt tilt() const { return filter_.tilt(); }
  /// Returns the report; none before 10 pairs of views.
  std::optional<MountReport> report() const;

 private:
  MountFilter filter_;
  double wheels_m_ = 0.0;
  double seen_m_ = 0.0;
};

/// Corrects a mount as seen from above, found from motions of a base that does not slide sideways (u_y = 0 in the
/// middle of each arc): straight drives show the yaw, turns how far ahead the camera sits.
struct MountLever {
  double yaw_rad = 0.0;    ///< to be added to the mount's
  double forward_m = 0.0;  ///< likewise
  double yaw_sigma_rad = 0.0;
  double forward_sigma_m = 0.0;
};
/// Returns the corrections; none of fewer than 5 motions. `before`: 1 sigma of both, which what is not seen keeps.
std::optional<MountLever> lever_from(const std::vector<Pose2>& a_from_b, double yaw_before_rad,
                                     double forward_before_m);

/// Returns the same camera with its mount corrected by `lever`.
CameraModel shifted(const CameraModel& camera, const MountLever& lever);

}  // namespace weft::agents
