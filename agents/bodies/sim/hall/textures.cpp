#include "agents/bodies/sim/hall/textures.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace weft::agents::sim {
namespace {

std::vector<std::uint8_t> halved(const std::vector<std::uint8_t>& from, int side) {
  std::vector<std::uint8_t> out;
  for (int y = 0; y < side; y += 2) {
    const auto* const row = from.data() + static_cast<std::ptrdiff_t>(y) * side;
    for (int x = 0; x < side; x += 2)
      out.push_back(static_cast<std::uint8_t>((row[x] + row[x + 1] + row[x + side] + row[x + side + 1] + 2) / 4));
  }
  return out;
}

/// Returns where in a texture a pattern begins along an axis, texels; unrelated to where the next pattern does.
float offset_of(std::uint32_t pattern, std::uint32_t axis) {
  std::uint32_t h = (pattern + 0x9E3779B9U * (axis + 1U)) * 0x85EBCA6BU;
  h = (h ^ (h >> 15U)) * 0xC2B2AE35U;
  return static_cast<float>((h >> 16U) & 0x3FFU);
}

}  // namespace

Texture::Texture(int side, std::vector<std::uint8_t> texels) : top_(std::countr_zero(static_cast<unsigned>(side))) {
  std::size_t level = 0;
  for (int s = side; s >= 1; s /= 2) {
    from_.at(level++) = static_cast<std::uint32_t>(texels_.size());
    texels_.insert(texels_.end(), texels.begin(), texels.end());
    if (s > 1) texels = halved(texels, s);
  }
}

Textures::Textures(const FloorSource& floor, std::uint64_t seed, const Photographed& photographed,
                   std::optional<Mural> ceiling) {
  constexpr std::uint64_t ducts = 6;  // what hangs is seen piece by piece, side by side
  for (std::size_t i = 0; i < kStuffs; ++i) {
    const auto stuff = static_cast<Stuff>(i);
    const auto given = photographed.find(stuff);
    if (given != photographed.end()) {
      of_[i] = given->second;
    } else if (stuff == Stuff::load) {
      of_[i] = draw_loads(seed);
    } else if (stuff == Stuff::sign) {
      of_[i] = draw_signs(seed);
    } else if (stuff == Stuff::floor) {
      of_[i].push_back(floor_texture(floor));
    } else if (stuff == Stuff::duct) {
      for (std::uint64_t k = 0; k < ducts; ++k) of_[i].push_back(draw_plain(stuff, seed + i + 1000 * k));
    } else if (stuff != Stuff::mural) {
      of_[i].push_back(draw_plain(stuff, seed + i));
    }
  }
  if (!ceiling) return;
  ceiling_x0_ = ceiling->x0;
  ceiling_y0_ = ceiling->y0;
  ceiling_texel_m_ = ceiling->texel_m;
  of_[static_cast<std::size_t>(Stuff::mural)].push_back({ceiling->side, std::move(ceiling->texels)});
}

/// Places a part of the ceiling on its picture; its `across` goes along x and its `up` along y, apart from a slope.
void Textures::place_on_ceiling(const Quad& quad, ShadedFace& face) const {
  face.per_m = static_cast<float>(1.0 / ceiling_texel_m_);
  face.per_u = quad.across.x() * face.per_m;
  face.per_v = quad.up.y() * face.per_m;
  face.at_u = (quad.corner.x() - static_cast<float>(ceiling_x0_)) * face.per_m;
  face.at_v = (quad.corner.y() - static_cast<float>(ceiling_y0_)) * face.per_m;
}

ShadedFace Textures::of(const Quad& quad) const {
  const std::vector<Texture>& textures = of_[static_cast<std::size_t>(quad.stuff)];
  const Texture& texture = textures[quad.pattern % textures.size()];
  const float across_m = quad.across.norm();
  const float up_m = quad.up.norm();
  ShadedFace face;
  face.levels = texture.levels();
  face.grey = quad.contrast * (quad.grey / 128.0F);
  face.ground = (1.0F - quad.contrast) * quad.grey;
  const Eigen::Vector3f normal = quad.normal();
  std::copy_n(normal.data(), 3, face.normal);
  if (is_fitted(quad.stuff)) {
    const auto side = static_cast<float>(texture.side());
    // Row 0 of a picture is its top.
    face.per_u = side;
    face.per_v = -side;
    face.at_v = side;
    face.per_m = side / std::max(across_m, up_m);
    return face;
  }
  if (quad.stuff == Stuff::mural) {
    place_on_ceiling(quad, face);
    return face;
  }
  face.per_m = 1.0F / static_cast<float>(kTexelM);
  face.per_u = across_m * face.per_m;
  face.per_v = up_m * face.per_m;
  face.at_u = offset_of(quad.pattern, 0);
  face.at_v = offset_of(quad.pattern, 1);
  return face;
}

Texture floor_texture(const FloorSource& floor) {
  constexpr int tiles = 4;
  constexpr int texels = kTileTexels / 8;  // 8 of the floor's make 5 mm
  cv::Mat whole(tiles * texels, tiles * texels, CV_8U);
  std::vector<std::uint8_t> tile(static_cast<std::size_t>(kTileTexels) * kTileTexels);
  for (int y = 0; y < tiles; ++y) {
    for (int x = 0; x < tiles; ++x) {
      floor.fill({x, y}, tile);
      cv::resize(cv::Mat(kTileTexels, kTileTexels, CV_8U, tile.data()),
                 whole(cv::Rect(x * texels, y * texels, texels, texels)), {texels, texels}, 0, 0, cv::INTER_AREA);
    }
  }
  const double mean = std::max(1.0, cv::mean(whole)[0]);
  whole.convertTo(whole, CV_8U, 128.0 / mean);
  return {tiles * texels, {whole.datastart, whole.dataend}};
}

}  // namespace weft::agents::sim
