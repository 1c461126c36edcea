#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace weft::agents::sim {

/// Divide the floor, an endless plane, into square tiles; tile (x, y) covers [x, x+1) x [y, y+1) tile lengths of the
/// site frame. Texel (i, j) of a tile, row-major with j along y, is the albedo about its centre, which lies (i + 0.5,
/// j + 0.5) texels from the tile's corner.
inline constexpr int kTileTexels = 1024;
inline constexpr double kTexelM = 0.625e-3;
inline constexpr double kTileM = kTileTexels * kTexelM;

struct TileKey {
  std::int32_t x = 0;
  std::int32_t y = 0;
  auto operator<=>(const TileKey&) const = default;
};

/// Is the texture of a floor.
class FloorSource {
 public:
  virtual ~FloorSource() = default;
  /// Fills one tile of kTileTexels x kTileTexels grey levels. Deterministic; neighbours fit together.
  virtual void fill(TileKey key, std::span<std::uint8_t> texels) const = 0;
  /// Returns the strength of the mirrored lamps, grey levels at their middle for a lamp of brightness 1.
  virtual double gloss() const = 0;
};

}  // namespace weft::agents::sim
