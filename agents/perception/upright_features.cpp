#include "agents/perception/upright_features.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/perception/describe_upright.hpp"
#include "agents/perception/opencv_view.hpp"
#include "agents/perception/spread_corners.hpp"

namespace weft::agents {
namespace {

/// Finds corners, weak ones only where strong ones are too few: well-lit scenes have plenty, and weak ones cost time.
std::vector<cv::KeyPoint> corners_of(const cv::Mat& grey, int count) {
  std::vector<cv::KeyPoint> found;
  for (const int threshold : {40, 24, 14, 8, 5}) {
    cv::AGAST(grey, found, threshold, true);
    if (found.size() >= static_cast<std::size_t>(2 * count)) break;
  }
  return found;
}

}  // namespace

int cell_px(const UprightConfig& config, int width_px) {
  return std::max(3, static_cast<int>(std::lround(config.cell_widths * width_px)));
}

std::vector<UprightFeature> upright_features(const Image& image, const UprightConfig& config) {
  constexpr int columns = 16;
  constexpr int rows = 8;
  const cv::Mat grey = as_mat(image);
  const UprightCells cells{cell_px(config, grey.cols), config.smoothing_cells};
  const int half = kUprightCells * cells.side_px / 2;
  const cv::Rect described(half, half, grey.cols - 2 * half, grey.rows - 2 * half);
  if (described.width < 1 || described.height < 1) return {};
  std::vector<cv::KeyPoint> corners = corners_of(grey, config.count);
  std::erase_if(corners, [&](const cv::KeyPoint& k) {
    return !described.contains({static_cast<int>(std::lround(k.pt.x)), static_cast<int>(std::lround(k.pt.y))});
  });
  corners = spread_corners(std::move(corners), grey.size(), columns, rows, config.count);
  std::vector<UprightFeature> features(corners.size());
  std::vector<cv::Point> at;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    features[i].pixel = {corners[i].pt.x, corners[i].pt.y};
    at.emplace_back(static_cast<int>(std::lround(corners[i].pt.x)), static_cast<int>(std::lround(corners[i].pt.y)));
  }
  const std::vector<Descriptor> descriptors =
      config.description == Description::brief ? compared_greys(grey, at, cells) : gradient_bits(grey, at, cells);
  for (std::size_t i = 0; i < features.size(); ++i) features[i].descriptor = descriptors[i];
  return features;
}

}  // namespace weft::agents
