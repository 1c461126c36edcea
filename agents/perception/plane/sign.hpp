#pragma once
#include <optional>
#include <span>
#include <vector>

#include "agents/perception/plane/feature.hpp"

namespace weft::agents {

/// Counts how often each of 512 words occurs among the features' descriptors, whichever way the robot looked: views
/// of one stretch of a plane are nearer to each other than nearly all others. None: there are no features.
std::optional<std::vector<float>> sign_features(std::span<const PlaneFeature> features);

}  // namespace weft::agents
