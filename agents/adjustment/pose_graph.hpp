#pragma once
#include <span>
#include <vector>

#include "agents/adjustment/window.hpp"

namespace weft::agents {

/// Moves the poses so that windows and stitches fit best, the first pose held: nonlinear least squares over SE(2),
/// at most so many iterations. A stitch that contradicts all others counts less (Cauchy's loss). A window counts
/// `share`, as neighbouring windows say the same. Returns whether it came to an end.
bool adjust_poses(std::vector<Pose2>& map_from_place, std::span<const WindowFit> windows,
                  std::span<const MosaicLink> stitches, double share, int iterations);

}  // namespace weft::agents
