#pragma once
#include <vector>

#include "agents/methods/topometric/config.hpp"
#include "agents/methods/topometric/content.hpp"
#include "agents/perception/stereo/rectifier.hpp"

namespace weft::agents {

/// Returns corners that both images of a pair show, described as the rectified left one shows them, at most as many
/// as are stored: of each part of the view the strongest first. The pair is of the rectifier's
/// size.
std::vector<SpaceFeature> space_features(const PlaceConfig& config, const Rectifier& rectifier,
                                         const StereoPair& pair, const Pose3& place_from_robot);

}  // namespace weft::agents
