#pragma once
#include <optional>

#include "agents/methods/floor/config.hpp"
#include "agents/perception/birds_eye.hpp"
#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/planar_motion.hpp"
#include "agents/perception/view.hpp"

namespace weft::agents {

/// Describes a motion that was seen without following corners.
struct SeenOtherwise {
  PlanarFit fit;
  std::size_t points = 0;  ///< that agree
};

/// Finds the motion by grey values, from near where it is expected: stands blur and pale floors. None: they do not
/// correlate.
std::optional<SeenOtherwise> see_directly(const CameraModel& camera, const Image& keyframe, const Image& now,
                                          const AttitudePrior& prior, const PlanarState& expected);

/// Finds the motion by binary features of the rectified floor, however far the view has moved: it tolerates jumps and
/// little overlap. None: too few features agree, or not on one plane.
std::optional<SeenOtherwise> see_by_features(const CameraModel& camera, const BirdsEye& birds_eye,
                                             const FloorConfig& config, const Image& keyframe, const Image& now,
                                             const AttitudePrior& prior, const PlanarState& expected);

}  // namespace weft::agents
