#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "agents/perception/hamming.hpp"

namespace weft::agents {

/// Holds a feature of a plane (a floor, a ceiling), as a view rectified to it shows it, or of what stands out from
/// the plane: each has its own height.
struct PlaneFeature {
  Eigen::Vector2d on_plane =
      Eigen::Vector2d::Zero();  ///< at its height, robot frame, as the mount says (no attitude)
  double heading_rad = 0.0;     ///< of the grey values around it, robot frame
  Descriptor descriptor{};
  double above_floor_m = 0.0;
  double above_floor_sigma_m = 0.0;  ///< 0: it is on the plane for certain
};

std::vector<Descriptor> descriptors_of(std::span<const PlaneFeature> features);

}  // namespace weft::agents
