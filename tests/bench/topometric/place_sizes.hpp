#pragma once
#include "tests/bench/topometric/place_runs.hpp"

namespace weft::bench {

/// Prints how many bytes a place has: as it is hashed and sent up, as it is kept and sent down, and decoded.
void print_place_sizes(const std::vector<RunPlace>& places);

}  // namespace weft::bench
