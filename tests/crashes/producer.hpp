#pragma once
#include <cstdint>

namespace weft::crashes {

/// Hands in batch after batch from `first` on and waits for each answer; reports what was acknowledged. Ends when the
/// keeper has gone.
void produce(std::uint64_t seed, std::uint32_t producer, std::uint64_t first, int keeper, int watcher);

}  // namespace weft::crashes
