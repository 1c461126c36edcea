#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "agents/bodies/sim/floor/source.hpp"
#include "agents/bodies/sim/hall/quad.hpp"

namespace weft::agents::sim {

/// Steps of sampling a texture, for every ray of an image: without a call.
namespace sampling {

/// Whole texels to and fro: 0 .. side - 1, then back.
inline int mirrored(int at, int side) {
  const int within = at & (2 * side - 1);
  return std::min(within, 2 * side - 1 - within);
}

/// Rounds down without a call; coordinates are far from an int's bounds.
inline int whole(float value) {
  const int cut = static_cast<int>(value);
  return cut - (value < static_cast<float>(cut) ? 1 : 0);
}

/// The power of two in a number of at least 1.
inline int log2_of(float value) {
  return static_cast<int>(std::bit_cast<std::uint32_t>(value) >> 23U) - 127;
}

}  // namespace sampling

/// Grey levels about a mean of 128, with its area-averaged halvings. Coordinates are mirrored beyond its rims, so
/// that nothing has a seam.
class Texture {
 public:
  /// `side` a power of two; `texels` side x side.
  Texture(int side, std::vector<std::uint8_t> texels);
  /// At (x, y) texels of level 0, from the level whose texels are as large as `texels` of those.
  float at(float x, float y, float texels) const;
  int side() const { return 1 << top_; }

 private:
  int top_ = 0;                           ///< side = 2^top_
  std::vector<std::uint8_t> texels_;      ///< all levels, one after the other
  std::array<std::uint32_t, 16> from_{};  ///< where each begins
};

inline float Texture::at(float x, float y, float texels) const {
  const int level = std::min(sampling::log2_of(std::max(1.0F, texels)), top_);
  const int side = 1 << (top_ - level);
  const std::uint8_t* const pixels = texels_.data() + from_[static_cast<std::size_t>(level)];
  const float scale = 1.0F / static_cast<float>(1 << level);
  const float column = x * scale - 0.5F;
  const float row = y * scale - 0.5F;
  const int left = sampling::whole(column);
  const int top = sampling::whole(row);
  const float s = column - static_cast<float>(left);
  const float t = row - static_cast<float>(top);
  const int x0 = sampling::mirrored(left, side);
  const int x1 = sampling::mirrored(left + 1, side);
  const std::uint8_t* const above = pixels + static_cast<std::ptrdiff_t>(sampling::mirrored(top, side)) * side;
  const std::uint8_t* const below = pixels + static_cast<std::ptrdiff_t>(sampling::mirrored(top + 1, side)) * side;
  const float over = static_cast<float>(above[x0]) + s * static_cast<float>(above[x1] - above[x0]);
  const float under = static_cast<float>(below[x0]) + s * static_cast<float>(below[x1] - below[x0]);
  return over + t * (under - over);
}

/// How a quad's own coordinates, [0, 1], and metres become a texture's.
struct Sampler {
  const Texture* texture = nullptr;
  float per_u = 1.0F, per_v = 1.0F, at_u = 0.0F, at_v = 0.0F;  ///< texels
  float per_m = 1.0F;
  /// Grey levels about 128, for a pixel that is `pixel_m` wide there.
  float at(float u, float v, float pixel_m) const {
    return texture->at(u * per_u + at_u, v * per_v + at_v, pixel_m * per_m);
  }
};

/// Textures of a stuff in place of those that are drawn; none is empty.
using Photographed = std::map<Stuff, std::vector<Texture>>;

/// What each stuff looks like. A texture of cloth, concrete or the like has its size in metres and goes on from quad
/// to quad; the picture of a load or a sign fills its quad.
class Textures {
 public:
  static constexpr double kTexelM = 0.005;

  /// Procedural but for what was photographed; `floor` is what the site's floor cameras see, too.
  Textures(const FloorSource& floor, std::uint64_t seed, const Photographed& photographed);

  /// Valid as long as this is.
  Sampler of(const Quad& quad) const;

 private:
  std::array<std::vector<Texture>, kStuffs> of_;
};

/// Stuffs whose pictures fill their quads.
constexpr bool is_fitted(Stuff stuff) {
  return stuff == Stuff::load || stuff == Stuff::sign;
}

/// Pictures of stacked cartons, wrapped pallets, drums, empty shelves; and of signs, doors and panels on walls. 128
/// texels a side.
std::vector<Texture> draw_loads(std::uint64_t seed);
std::vector<Texture> draw_signs(std::uint64_t seed);
/// 5 mm a texel, 2.56 m.
Texture draw_plain(Stuff stuff, std::uint64_t seed);
Texture floor_texture(const FloorSource& floor);

}  // namespace weft::agents::sim
