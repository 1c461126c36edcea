#pragma once
#include <span>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/hamming.hpp"
#include "agents/perception/planar_motion.hpp"
#include "agents/perception/plane/feature.hpp"

namespace weft::agents {

/// Refers to the features of one view, and to the camera by whose mount they were rectified.
struct MountedFeatures {
  const CameraModel& camera;
  std::span<const PlaneFeature> features;
};

/// Returns the pairs of points that matches stand for, in the images again, each at the height that both features
/// together say. `feature_sigma_m`: of a feature on its plane.
std::vector<PlanePair> feature_pairs(const MountedFeatures& a, const MountedFeatures& b,
                                     std::span<const Match> matches, double feature_sigma_m);

}  // namespace weft::agents
