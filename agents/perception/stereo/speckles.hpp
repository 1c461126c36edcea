#pragma once
#include <cstdint>
#include <vector>

namespace weft::agents {

/// Writes `none` over patches of fewer than `fewest` pixels, which are mostly mismatches: pixels that lie side by
/// side or one below the other are of one patch when their values differ by `range` at most. `values` are rows of
/// `width`.
void remove_speckles(std::vector<std::int16_t>& values, int width, int fewest, int range, std::int16_t none);

}  // namespace weft::agents
