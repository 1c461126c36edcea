#pragma once
#include <cstdint>
#include <vector>

#include "agents/bodies/sim/floor/layer.hpp"

namespace weft::agents::sim {

/// Is the side in texels of square tiles, all with one print, between joints: a floor that does repeat.
inline constexpr int kPrintTexels = 480;

class TilePrint {
 public:
  /// Draws the print; another seed gives another print.
  explicit TilePrint(std::uint64_t seed);
  /// Adds the tiles on a canvas of finest texels.
  void add(const Layer& layer) const;

 private:
  std::vector<float> grey_, warmth_;  ///< row-major, kPrintTexels a side
};

}  // namespace weft::agents::sim
