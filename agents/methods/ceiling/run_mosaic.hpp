#pragma once
#include <cstdint>
#include <vector>

#include "agents/adjustment/mosaic.hpp"
#include "agents/methods/ceiling/config.hpp"
#include "agents/methods/ceiling/content.hpp"
#include "agents/methods/ceiling/run_corners.hpp"
#include "agents/methods/method.hpp"

namespace weft::agents {

using CeilingRun = std::vector<ExperiencePlace<CeilingContent>>;

/// Holds a run as it is adjusted, and where what was sighted comes from.
struct RunMosaic {
  Mosaic mosaic;                        ///< its places are the run's, in their order
  std::vector<std::uint32_t> features;  ///< of each sighting: index into the features of its place
};

/// Returns whether a run can be adjusted: two places or more, all of whose contents one camera made below one height
/// of the ceiling, each joined to the next one by a Metric2.
bool is_adjustable(const CeilingRun& run);

/// Returns how a place lies to the one before it, as it was taught. The run is adjustable; `place` >= 1.
Metric2 taught_step(const CeilingRun& run, std::size_t place);

/// Returns the mosaic of an adjustable run: poses by odometry; of the corners those that are seen longest, about 150
/// a place, each where its best known feature has it; odometry, and stitches within the run.
RunMosaic mosaic_of(const CeilingConfig& config, const CeilingRun& run,
                    const std::vector<std::vector<RunFeature>>& corners);

/// Returns what an adjusted mosaic changes of its run: the relations of all edges within it, and of contents the
/// attitude, and the heights of features that are better known now. Covariances stay as taught: what they say of the
/// scale no adjustment improves, and they are never too small.
Amendments<CeilingContent> amendments_of(const CeilingConfig& config, const CeilingRun& run, const Mosaic& adjusted,
                                         const std::vector<std::uint32_t>& features);

}  // namespace weft::agents
