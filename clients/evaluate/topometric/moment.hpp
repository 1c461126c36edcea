#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agents/navigation/navigator.hpp"
#include "core/geometry/pose2.hpp"
#include "core/ids.hpp"

/// Holds the study of the method `topometric` (docs/topometric-study.md).
namespace weft::evaluate::topometric {

/// Tells where a robot believes to be.
struct BelievedAt {
  PlaceId place;
  Pose2 place_from_robot;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< as Metric2's
};

/// Holds one sample of a robot: what it inferred and, beside it, what was true.
struct Moment {
  std::uint64_t frame = 0;
  double sensor_s = 0.0;  ///< the sample's own stamp
  bool has_view = false;
  bool seen = false;  ///< odometry saw its step; otherwise commands were integrated
  std::string_view blind_reason;
  Pose2 step;                  ///< previous_from_current
  Pose2 start_from_robot;      ///< by the odometry of the method
  Pose2 raw_start_from_robot;  ///< by vision alone: blind is no motion
  std::optional<BelievedAt> believed;
  std::optional<BelievedAt> fix;
  std::optional<PlaceId> kept;  ///< the place that was kept here
  agents::Twist command;
  agents::Following following = agents::Following::none;
  std::string_view reason;  ///< why it stands
  bool lost = false;
  bool has_switched = false;                                       ///< it believes in another chart from here on
  double jump_m = std::numeric_limits<double>::quiet_NaN();        ///< of what is believed, where it has switched
  double processor_ms = std::numeric_limits<double>::quiet_NaN();  ///< of navigating; only with a view

  // Truth; for scoring only.
  double true_s = 0.0;
  Pose2 site_from_robot;
  std::optional<std::string> touch = {};
};
using Moments = std::vector<Moment>;

/// Tells where places truly are.
using TruePlaces = std::map<PlaceId, Pose2>;

}  // namespace weft::evaluate::topometric
