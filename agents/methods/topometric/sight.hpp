#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "agents/methods/topometric/config.hpp"
#include "agents/perception/scan.hpp"
#include "agents/perception/stereo/disparity.hpp"
#include "agents/perception/stereo/stereo_rig.hpp"

namespace weft::agents {

/// Returns how far a pair's depths are used: as far as the settings say and its noise allows.
double sight_range_m(const SightConfig& config, const StereoRig& rig);

/// Returns the settings of a scan that is made of what this pair sees.
PseudoScanConfig scan_of_pair(PseudoScanConfig scan, const SightConfig& sight, const DisparityConfig& disparity,
                              const StereoRig& rig);

/// Returns the pose of a robot's frame above a floor: level, heading kept. `up` is the floor's normal in the robot's
/// frame, `height_m` what its origin is above the floor.
Pose3 level_above(const Eigen::Vector3d& up, double height_m);

/// Holds a floor that one view has shown.
struct FloorOfView {
  Pose3 level_from_robot;
  std::size_t points = 0;
};

/// Fits a plane to the points near where the floor was before, by least squares: farther points count less, and what
/// was before counts as much as a look at it. None: too few points, or a plane too far from what the mount says.
std::optional<FloorOfView> fit_floor(std::span<const Eigen::Vector3f> in_robot, const StereoRig& rig,
                                     const Pose3& level_from_robot_before, const SightConfig& config);

/// Holds what one pair has shown.
struct Sight {
  std::vector<Eigen::Vector3f> in_robot;  ///< within range, not above what is stored
  Pose3 level_from_robot;
  Scan scan;
};

/// Returns what a rectified pair shows. Refusals: those of match_disparity.
OrUnseen<Sight> look_with(const TopometricConfig& config, const StereoRig& rig, const StereoPair& rectified,
                          const Pose3& level_from_robot_before);

}  // namespace weft::agents
