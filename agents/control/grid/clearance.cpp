#include "agents/control/grid/clearance.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace weft::agents {
namespace {

/// Returns the distance of each pixel to the nearest that is zero, in pixels.
cv::Mat pixels_to_zero(const cv::Mat& mask) {
  cv::Mat pixels;
  cv::distanceTransform(mask, pixels, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return pixels;
}

/// Returns the distances of a part of the image as a map, at most `most_m` each.
DistanceMap map_of(const Raster& raster, const cv::Mat& pixels, int border, double most_m) {
  DistanceMap map{raster, std::vector<float>(raster.size())};
  const auto cell_m = static_cast<float>(raster.cell_m);
  const auto most = static_cast<float>(most_m);
  for (int row = 0; row < raster.rows; ++row) {
    const float* const from = pixels.ptr<float>(row + border) + border;
    float* const to = map.metres.data() + raster.index({0, row});
    std::transform(from, from + raster.columns, to, [&](float pixel) { return std::min(cell_m * pixel, most); });
  }
  return map;
}

}  // namespace

DistanceMap distance_to_occupied(const OccupancyGrid& grid, double most_m) {
  const Raster& raster = grid.raster;
  if (raster.size() == 0) return {raster, {}};
  const bool has_any = std::find(grid.cells.begin(), grid.cells.end(), CellState::occupied) != grid.cells.end();
  if (!has_any) return {raster, std::vector<float>(raster.size(), static_cast<float>(most_m))};
  cv::Mat mask(raster.rows, raster.columns, CV_8UC1);
  std::transform(grid.cells.begin(), grid.cells.end(), mask.data,
                 [](CellState state) { return static_cast<std::uint8_t>(state == CellState::occupied ? 0 : 1); });
  return map_of(raster, pixels_to_zero(mask), 0, most_m);
}

DistanceMap clearance_of(const OccupancyGrid& grid) {
  const Raster& raster = grid.raster;
  if (raster.size() == 0) return {raster, {}};
  cv::Mat mask = cv::Mat::zeros(raster.rows + 2, raster.columns + 2, CV_8UC1);
  for (int row = 0; row < raster.rows; ++row) {
    const auto first = grid.cells.begin() + static_cast<std::ptrdiff_t>(raster.index({0, row}));
    std::transform(first, first + raster.columns, mask.ptr<std::uint8_t>(row + 1) + 1,
                   [](CellState state) { return static_cast<std::uint8_t>(state == CellState::free ? 1 : 0); });
  }
  return map_of(raster, pixels_to_zero(mask), 1, raster.cell_m * static_cast<double>(raster.columns + raster.rows));
}

}  // namespace weft::agents
