#include "agents/perception/spread_corners.hpp"

#include <algorithm>

namespace weft::agents {

std::vector<cv::KeyPoint> spread_corners(std::vector<cv::KeyPoint> found, const cv::Size& size, int columns, int rows,
                                         int count) {
  std::vector<std::vector<cv::KeyPoint>> cells(static_cast<std::size_t>(columns * rows));
  std::stable_sort(found.begin(), found.end(),
                   [](const cv::KeyPoint& a, const cv::KeyPoint& b) { return a.response > b.response; });
  for (const cv::KeyPoint& k : found) {
    const int column = static_cast<int>(k.pt.x) * columns / size.width;
    const int row = static_cast<int>(k.pt.y) * rows / size.height;
    cells[static_cast<std::size_t>(row * columns + column)].push_back(k);
  }
  std::vector<cv::KeyPoint> kept;
  const auto wanted = static_cast<std::size_t>(count);
  for (std::size_t turn = 0; kept.size() < wanted; ++turn) {
    const std::size_t before = kept.size();
    for (const auto& cell : cells)
      if (turn < cell.size() && kept.size() < wanted) kept.push_back(cell[turn]);
    if (kept.size() == before) break;
  }
  return kept;
}

}  // namespace weft::agents
