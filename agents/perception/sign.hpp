#pragma once
#include <optional>
#include <span>
#include <vector>

#include "agents/perception/hamming.hpp"

namespace weft::agents {

/// Counts how often each of 512 words occurs among descriptors: views of one place are nearer to each other than
/// nearly all others. None: there are no descriptors.
std::optional<std::vector<float>> sign_descriptors(std::span<const Descriptor> descriptors);

}  // namespace weft::agents
