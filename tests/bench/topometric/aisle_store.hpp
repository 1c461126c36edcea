#pragma once
#include <cstddef>
#include <filesystem>

#include "core/result.hpp"
#include "tests/bench/topometric/place_runs.hpp"

namespace weft::bench {

/// Writes a store of one run of so many places, half a metre apart, as intake commits it: contents are those given,
/// in turn, each point moved by up to a quantum so that none is the same as another. Prints how long it takes and how
/// large the store is. Errors of the store.
Result<void> write_aisle(const std::vector<RunPlace>& contents, std::size_t places,
                         const std::filesystem::path& directory);

}  // namespace weft::bench
