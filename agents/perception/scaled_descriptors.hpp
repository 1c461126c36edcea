#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "agents/perception/hamming.hpp"
#include "agents/perception/view.hpp"

namespace weft::agents {

/// Names a point of an image, and how large the cells of its descriptor are there.
struct ScaledPoint {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double cell_px = 6.0;
};

/// Describes points by the gradients around them (Description::gradients), each in cells of its own size: where depth
/// is known, cells of one size in space look alike from near and from afar. Sizes are kept to a sixth, within
/// 3 and 20 pixels. None: too near to the image's rim. The image is whole (`is_whole`).
std::vector<std::optional<Descriptor>> describe_at_scale(const Image& image, std::span<const ScaledPoint> points);

}  // namespace weft::agents
