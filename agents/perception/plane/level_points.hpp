#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "agents/perception/attitude.hpp"
#include "agents/perception/camera_model.hpp"
#include "agents/perception/plane/feature.hpp"

namespace weft::agents {

/// Returns where each feature lies in the robot's level frame, at its own height: the view's attitude, which the
/// mount leaves out, is undone.
std::vector<Eigen::Vector2d> level_points(const CameraModel& camera, const Attitude& attitude,
                                          std::span<const PlaneFeature> features);

}  // namespace weft::agents
