#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "agents/perception/hamming.hpp"
#include "agents/perception/view.hpp"

namespace weft::agents {

/// Describes a corner of a view that looks ahead. Descriptors do not turn with the grey values around it as on a
/// floor: robots hardly roll, and what is upright in the world tells the corners of a rack from one another.
struct UprightFeature {
  Eigen::Vector2f pixel = Eigen::Vector2f::Zero();
  Descriptor descriptor{};
};

enum class Description : std::uint8_t {
  /// Compares smoothed grey values at 256 pairs of points (Calonder et al. 2010, BRIEF).
  brief,
  /// Measures the gradient's strength in 4 x 4 cells and 8 directions, each a bit for more than the mean of its
  /// direction and one for more than the mean of its cell: a histogram of gradients (Dalal & Triggs 2005) in 256
  /// bits.
  gradients,
};

struct UprightConfig {
  Description description = Description::gradients;
  int count = 2000;               ///< [1, 5000] features at most
  double cell_widths = 1.0 / 64;  ///< [0.005, 0.05] of the image's width; a descriptor sees 4 x 4 cells
  double smoothing_cells = 0.1;   ///< [0.02, 1] of grey values before they are compared or differentiated
};

/// Returns the side of a descriptor's cell, in pixels; at least 3.
int cell_px(const UprightConfig& config, int width_px);

/// Returns AGAST corners (Mair et al. 2010) spread over the image, the strongest of each part first. None when the
/// image shows none or is smaller than what a descriptor sees. The image is whole (`is_whole`).
std::vector<UprightFeature> upright_features(const Image& image, const UprightConfig& config);

}  // namespace weft::agents
