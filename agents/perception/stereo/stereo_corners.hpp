#pragma once
#include <Eigen/Core>
#include <vector>

#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/stereo/rectifier.hpp"

namespace weft::agents {

struct StereoCornerBounds {
  double row_px = 1.0;          ///< by which a corner's rows may differ in the two images, rectified
  double least_px = 0.7;        ///< of disparity: what is further away tells no depth
  double most_px = 96.0;        ///< what is nearer is not looked for
  double most_error_grey = 18;  ///< mean difference of the two windows, grey levels
};

/// Holds a corner that both cameras see.
struct StereoCorner {
  Eigen::Vector2d taken;      ///< pixel of the left image as it was taken
  Eigen::Vector3d in_camera;  ///< the rig's camera frame
  double disparity_px = 0.0;
};

/// Finds corners of the left image in the right one: coarsely by the least difference of grey values along the row,
/// then as a tracker does; those that lie on another row are left out. The images are as taken and prepared alike.
std::vector<StereoCorner> in_both(const Rectifier& rectifier, const TrackingImage& left, const TrackingImage& right,
                                  const std::vector<Eigen::Vector2d>& corners, const StereoCornerBounds& bounds);

}  // namespace weft::agents
