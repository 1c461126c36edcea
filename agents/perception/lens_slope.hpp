#pragma once
#include <Eigen/Core>

#include "agents/perception/camera_model.hpp"

namespace weft::agents {

/// Returns how far a pixel moves by a small change of its normalised coordinates, over the focal length: the identity
/// where a lens bends nothing. Normalised coordinates grow as the tangent of the angle off the axis, the pixels of an
/// equidistant lens as the angle itself: at 1.2 rad a pixel is worth 7.6 times as much of them outwards, and 2.1
/// times around. What is left of a track is noise of the image, so it is measured there.
Eigen::Matrix2d pixels_by_normalised(const CameraModel& camera, const Eigen::Vector2d& normalised);

}  // namespace weft::agents
