#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "agents/bodies/sim/floor/source.hpp"
#include "agents/bodies/sim/hall/quad.hpp"

namespace weft::agents::sim {

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
  int top_ = 0;  ///< side = 2^top_
  std::vector<std::vector<std::uint8_t>> levels_;
};

/// What each stuff looks like. A texture of cloth, concrete or the like has its size in metres and goes on from quad
/// to quad; the picture of a load or a sign fills its quad.
class Textures {
 public:
  static constexpr double kTexelM = 0.005;

  /// Procedural; `floor` is what the site's floor cameras see, too.
  Textures(const FloorSource& floor, std::uint64_t seed);

  /// Grey levels about 128 at (u, v) of the quad, for a pixel that is `pixel_m` wide there.
  float at(const Quad& quad, float across_m, float up_m, float u, float v, float pixel_m) const;

  /// Photographs in place of what is drawn: `fitted`: each fills its quad; else 5 mm a texel.
  void replace(Stuff stuff, std::vector<Texture> textures) {
    of_[static_cast<std::size_t>(stuff)] = std::move(textures);
  }

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
