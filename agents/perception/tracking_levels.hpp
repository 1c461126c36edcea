#pragma once
// Private to the rooms that compute with OpenCV; never included by a public header.
#include <opencv2/core.hpp>
#include <vector>

#include "agents/perception/corner_tracks.hpp"

namespace weft::agents {

struct TrackingImage::Levels {
  cv::Mat image;
  std::vector<cv::Mat> pyramid;  ///< as cv::buildOpticalFlowPyramid leaves it: a level, its derivatives, ...
  int window_px = 11;
  int top = 3;
};

}  // namespace weft::agents
