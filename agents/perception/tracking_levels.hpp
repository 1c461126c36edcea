#pragma once
// Private to the rooms that compute with OpenCV; never included by a public header.
#include <opencv2/core.hpp>
#include <vector>

#include "agents/perception/corner_tracks.hpp"

namespace weft::agents {

struct TrackingImage::Levels {
  cv::Mat image;
  std::vector<cv::Mat> pyramid;  ///< as cv::buildOpticalFlowPyramid leaves it: a level, its gradients, ...
  bool has_gradients = true;     ///< else the pyramid is of levels alone
  int window_px = 11;
  int top = 3;

  const cv::Mat& level(int i) const { return pyramid[static_cast<std::size_t>(has_gradients ? 2 * i : i)]; }
};

}  // namespace weft::agents
