#pragma once
#include <cstdint>

#include "agents/bodies/sim/floor/layer.hpp"

namespace weft::agents::sim {

/// Adds wooden planks, 0.084 to 0.156 m wide and 0.9 to 1.5 m long, laid along x: each with its own grey, warmth,
/// grain and knots, all functions of the seed and of where it lies.
void add_planks(std::uint64_t seed, const Layer& layer);

}  // namespace weft::agents::sim
