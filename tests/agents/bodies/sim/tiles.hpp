#pragma once
#include <opencv2/imgproc.hpp>
#include <vector>

#include "agents/bodies/sim/floor/source.hpp"

namespace weft::agents::sim {

using Tile = std::vector<std::uint8_t>;

inline Tile tile_of(const FloorSource& floor, TileKey key) {
  Tile tile(static_cast<std::size_t>(kTileTexels) * kTileTexels);
  floor.fill(key, tile);
  return tile;
}

inline cv::Mat picture_of(Tile& tile) {
  return cv::Mat(kTileTexels, kTileTexels, CV_8U, tile.data());
}

/// Returns the best correlation of a patch of one tile anywhere in another.
inline double best_match(Tile& of, Tile& in) {
  cv::Mat scores;
  const cv::Mat patch = picture_of(of)(cv::Rect(400, 400, 160, 160));
  cv::matchTemplate(picture_of(in), patch, scores, cv::TM_CCOEFF_NORMED);
  double best = 0.0;
  cv::minMaxLoc(scores, nullptr, &best);
  return best;
}

}  // namespace weft::agents::sim
