#pragma once
// Private to the rooms that compute with OpenCV; never included by a public header.
#include <opencv2/core.hpp>
#include <vector>

namespace weft::agents {

struct HarrisConfig {
  double sensitivity = 0.04;  ///< s of the response
  double window_px = 1.5;     ///< sigma of the Gaussian window w
  double least_share = 1e-4;  ///< of the strongest response
};

/// Returns R = AB - C^2 - s (A + B)^2 of each pixel, with A = I_x^2 * w, B = I_y^2 * w and C = (I_x I_y) * w (Harris
/// & Stephens 1988; Lucas et al., II.B, who print C as (I_x I_y)^2 * w: that would count corners of falling and of
/// rising diagonals alike). 32-bit floating point; `grey` is 8-bit.
cv::Mat harris_response(const cv::Mat& grey, const HarrisConfig& config);

/// Returns the pixels whose response is the largest among their eight neighbours', and not too small.
std::vector<cv::KeyPoint> harris_corners(const cv::Mat& grey, const HarrisConfig& config);

}  // namespace weft::agents
