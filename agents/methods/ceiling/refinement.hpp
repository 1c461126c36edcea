#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "agents/adjustment/mosaic_adjustment.hpp"
#include "agents/methods/ceiling/run_corners.hpp"
#include "agents/methods/ceiling/run_mosaic.hpp"

namespace weft::agents {

/// Holds a taught run while it is refined: first its corners are followed from place to place, then it is adjusted.
struct CeilingRefinement {
  CeilingRun run;                                ///< empty: there is nothing to refine
  std::vector<std::vector<Eigen::Vector2d>> at;  ///< features of the places followed so far, in their level frames
  RunCorners corners;                            ///< of the same places
  std::vector<std::uint32_t> features;           ///< as RunMosaic
  std::optional<MosaicAdjustment> adjustment;    ///< none: corners are still followed
};

}  // namespace weft::agents
