#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "agents/perception/hamming.hpp"

namespace weft::agents {

/// Holds a feature of a plane (a floor, a ceiling), as a view rectified to it shows it.
struct PlaneFeature {
  Eigen::Vector2d on_plane = Eigen::Vector2d::Zero();  ///< robot frame, as the mount says (no attitude)
  double heading_rad = 0.0;                            ///< of the grey values around it, robot frame
  Descriptor descriptor{};
};

std::vector<Descriptor> descriptors_of(std::span<const PlaneFeature> features);

}  // namespace weft::agents
