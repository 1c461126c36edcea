#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "agents/navigation/navigator.hpp"
#include "core/geometry/pose2.hpp"
#include "core/ids.hpp"

namespace weft::evaluate::floor {

/// Holds a fix as the robot accepted it.
struct FixSeen {
  PlaceId place;
  Pose2 measured;  ///< place_from_robot that the two contents agree on
  Pose2 believed;  ///< place_from_robot as believed with it
};

/// Holds one sample of a robot: what it inferred and, beside it, what was true.
struct Moment {
  std::uint64_t frame = 0;
  double sensor_s = 0.0;   ///< the sample's own stamp
  Pose2 start_from_robot;  ///< odometry
  /// States the covariance of the step that led here, as the method has it.
  Eigen::Matrix3d step_covariance = Eigen::Matrix3d::Zero();
  agents::CommonErrors step_common = agents::CommonErrors::Zero();
  bool seen = false;        ///< vision took part; otherwise wheels or commands were integrated
  std::size_t matches = 0;  ///< inliers of the motion
  std::optional<FixSeen> fix;
  std::optional<PlaceId> kept;  ///< the place that was kept here
  bool lost = false;
  agents::Following following = agents::Following::none;

  // Truth; for scoring only.
  double true_s = 0.0;
  Pose2 site_from_robot;
};

/// Holds one drive, sample by sample.
struct Trace {
  std::vector<Moment> moments;
  std::map<std::string, std::uint64_t> refusals;  ///< by name, of localisation and odometry
  double wall_s = 0.0;                            ///< that the whole took to compute, the simulation included
};

/// Tells where places are that robots have kept.
struct PlaceSet {
  std::map<PlaceId, Pose2> site_from_place;   ///< truly
  std::map<PlaceId, Pose2> start_from_place;  ///< by the odometry of the robot that kept it
};
PlaceSet places_of(const Trace& taught);

/// Returns the metres truly driven up to each moment.
std::vector<double> metres_driven(const Trace& trace);

}  // namespace weft::evaluate::floor
