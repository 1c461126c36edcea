#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "agents/bodies/sim/floor/source.hpp"
#include "agents/bodies/sim/hall/mural.hpp"
#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/hall/shade.hpp"

namespace weft::agents::sim {

/// Holds grey levels about a mean of 128, with their area-averaged halvings. Coordinates are mirrored beyond its
/// rims, so that nothing has a seam.
class Texture {
 public:
  /// Takes side x side texels, `side` a power of two, and makes the halvings.
  Texture(int side, std::vector<std::uint8_t> texels);
  /// Returns all levels; valid as long as this is.
  TexelLevels levels() const { return {texels_.data(), from_.data(), top_}; }
  int side() const { return 1 << top_; }

 private:
  int top_ = 0;                           ///< side = 2^top_
  std::vector<std::uint8_t> texels_;      ///< all levels, one after the other
  std::array<std::uint32_t, 16> from_{};  ///< where each begins
};

/// Holds textures of a stuff in place of those that are drawn; none of its lists is empty.
using Photographed = std::map<Stuff, std::vector<Texture>>;

/// Holds the textures of each stuff. A texture of cloth, concrete or the like has its size in metres and goes on from
/// quad to quad; the picture of a load or a sign fills its quad.
class Textures {
 public:
  static constexpr double kTexelM = 0.005;

  /// Draws all but what was photographed; `floor` is what the site's floor cameras see, too.
  /// `ceiling`: what faces of Stuff::mural show; none: there are no such faces.
  Textures(const FloorSource& floor, std::uint64_t seed, const Photographed& photographed,
           std::optional<Mural> ceiling = std::nullopt);

  /// Returns a quad's face without its light. Valid as long as this is.
  ShadedFace of(const Quad& quad) const;

 private:
  void place_on_ceiling(const Quad& quad, ShadedFace& face) const;

  std::array<std::vector<Texture>, kStuffs> of_;
  double ceiling_x0_ = 0.0, ceiling_y0_ = 0.0, ceiling_texel_m_ = 1.0;
};

/// Returns whether a stuff's pictures fill their quads.
constexpr bool is_fitted(Stuff stuff) {
  return stuff == Stuff::load || stuff == Stuff::sign;
}

/// Draw pictures of stacked cartons, wrapped pallets, drums, empty shelves; and of signs, doors and panels on walls.
/// They have 128 texels a side.
std::vector<Texture> draw_loads(std::uint64_t seed);
std::vector<Texture> draw_signs(std::uint64_t seed);
/// Return a texture of 5 mm a texel, 2.56 m a side.
Texture draw_plain(Stuff stuff, std::uint64_t seed);
Texture floor_texture(const FloorSource& floor);

}  // namespace weft::agents::sim
