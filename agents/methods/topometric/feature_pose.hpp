#pragma once
#include <cstdint>
#include <optional>

#include "agents/methods/topometric/config.hpp"
#include "agents/methods/topometric/content.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Holds where a place sees a robot by its features, in the plane.
struct FeaturePose {
  Pose2 place_from_robot;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of xi in place_from_robot * se2_exp(xi)
  std::uint32_t inliers = 0;
};

/// Finds the planar pose that most pairs of like features agree with, heights included, and fits it to these. It is
/// for each view: much cheaper than to relate two places, and it is wrong now and then. None: too few agree.
std::optional<FeaturePose> pose_by_features(const RelateConfig& config, const TopometricContent& place,
                                            const TopometricContent& seen);

}  // namespace weft::agents
