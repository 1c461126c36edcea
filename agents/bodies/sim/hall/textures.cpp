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

/// Whole texels to and fro: 0 .. side - 1, then back.
int mirrored(int at, int side) {
  const int within = at & (2 * side - 1);
  return within < side ? within : 2 * side - 1 - within;
}

/// A place in a texture that has nothing to do with the next pattern's.
float offset_of(std::uint32_t pattern, std::uint32_t axis) {
  std::uint32_t h = (pattern + 0x9E3779B9U * (axis + 1U)) * 0x85EBCA6BU;
  h = (h ^ (h >> 15U)) * 0xC2B2AE35U;
  return static_cast<float>((h >> 16U) & 0x3FFU);
}

}  // namespace

Texture::Texture(int side, std::vector<std::uint8_t> texels)
    : top_(std::countr_zero(static_cast<unsigned>(side))), levels_{std::move(texels)} {
  for (int s = side; s > 1; s /= 2) levels_.push_back(halved(levels_.back(), s));
}

float Texture::at(float x, float y, float texels) const {
  const int level = std::clamp(std::ilogb(std::max(1.0F, texels)), 0, top_);
  const int side = 1 << (top_ - level);
  const std::uint8_t* const pixels = levels_[static_cast<std::size_t>(level)].data();
  const float scale = 1.0F / static_cast<float>(1 << level);
  const float column = x * scale - 0.5F;
  const float row = y * scale - 0.5F;
  const float left = std::floor(column);
  const float top = std::floor(row);
  const float s = column - left;
  const float t = row - top;
  const int x0 = mirrored(static_cast<int>(left), side);
  const int x1 = mirrored(static_cast<int>(left) + 1, side);
  const std::uint8_t* const above =
      pixels + static_cast<std::ptrdiff_t>(mirrored(static_cast<int>(top), side)) * side;
  const std::uint8_t* const below =
      pixels + static_cast<std::ptrdiff_t>(mirrored(static_cast<int>(top) + 1, side)) * side;
  const float over = static_cast<float>(above[x0]) + s * static_cast<float>(above[x1] - above[x0]);
  const float under = static_cast<float>(below[x0]) + s * static_cast<float>(below[x1] - below[x0]);
  return over + t * (under - over);
}

Textures::Textures(const FloorSource& floor, std::uint64_t seed) {
  for (std::size_t i = 0; i < kStuffs; ++i) {
    const auto stuff = static_cast<Stuff>(i);
    if (stuff == Stuff::load) {
      of_[i] = draw_loads(seed);
    } else if (stuff == Stuff::sign) {
      of_[i] = draw_signs(seed);
    } else if (stuff == Stuff::floor) {
      of_[i].push_back(floor_texture(floor));
    } else {
      of_[i].push_back(draw_plain(stuff, seed + i));
    }
  }
}

float Textures::at(const Quad& quad, float across_m, float up_m, float u, float v, float pixel_m) const {
  const std::vector<Texture>& textures = of_[static_cast<std::size_t>(quad.stuff)];
  const Texture& texture = textures[quad.pattern % textures.size()];
  const auto side = static_cast<float>(texture.side());
  if (is_fitted(quad.stuff)) {
    // Row 0 of a picture is its top.
    return texture.at(u * side, (1.0F - v) * side, pixel_m * side / std::max(across_m, up_m));
  }
  constexpr float per_m = 1.0F / static_cast<float>(kTexelM);
  return texture.at(u * across_m * per_m + offset_of(quad.pattern, 0), v * up_m * per_m + offset_of(quad.pattern, 1),
                    pixel_m * per_m);
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
